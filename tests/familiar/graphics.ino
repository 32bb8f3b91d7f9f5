// A sketch for Adafruit_GFX and Adafruit_ILI9341, of which only the includes are changed:
//   #include "SPI.h"
//   #include "Adafruit_GFX.h"
//   #include "Adafruit_ILI9341.h"
#include "ports/familiar/gfx.hpp"

#define TFT_DC 9
#define TFT_CS 10

Adafruit_ILI9341 tft = Adafruit_ILI9341(TFT_CS, TFT_DC);

static const uint8_t bell[] = {
    0x01, 0x80, 0x03, 0xC0, 0x0F, 0xF0, 0x1F, 0xF8, 0x1F, 0xF8, 0x3F, 0xFC, 0x3F, 0xFC, 0x3F, 0xFC,
    0x3F, 0xFC, 0x7F, 0xFE, 0x7F, 0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0x07, 0xE0, 0x03, 0xC0};

void setup() {
  tft.begin();
  tft.setRotation(0);
  tft.fillScreen(ILI9341_NAVY);
}

void frameTitle(const char *title) {
  int16_t x1, y1;
  uint16_t w, h;

  tft.setTextSize(2);
  tft.getTextBounds(title, 0, 0, &x1, &y1, &w, &h);
  tft.fillRect(0, 0, tft.width(), h + 12, ILI9341_BLUE);
  tft.drawFastHLine(0, h + 12, tft.width(), ILI9341_CYAN);
  tft.setCursor((tft.width() - w) / 2, 6);
  tft.setTextColor(ILI9341_WHITE);
  tft.print(title);
  tft.drawBitmap(218, 6, bell, 16, 16, ILI9341_YELLOW);
}

void loop() {
  frameTitle("Boiler");
  for (int i = 0; i < 12; i++) // a fan of lines
    tft.drawLine(10, 44, 110, 44 + i * 8, tft.color565(255, 20 * i, 0));
  for (int r = 4; r <= 44; r += 8)
    tft.drawCircle(175, 90, r, tft.color565(0, 255 - 4 * r, 255));
  tft.fillCircle(175, 90, 12, ILI9341_ORANGE);
  for (int i = 0; i < 4; i++) {
    tft.fillRoundRect(10 + 56 * i, 150, 50, 34, 4 + 4 * i, tft.color565(40 * i + 60, 120, 60));
    tft.drawRoundRect(10 + 56 * i, 150, 50, 34, 4 + 4 * i, ILI9341_WHITE);
  }
  tft.fillTriangle(30, 250, 10, 200, 70, 210, ILI9341_RED);
  tft.drawTriangle(90, 250, 70, 200, 130, 210, ILI9341_GREEN);
  tft.drawRect(140, 200, 90, 50, ILI9341_MAGENTA);
  tft.drawFastVLine(185, 200, 50, ILI9341_MAGENTA);
  tft.drawPixel(160, 225, ILI9341_WHITE);

  tft.setCursor(0, 262);
  tft.setTextSize(1);
  tft.setTextColor(ILI9341_YELLOW);
  tft.println("Hello World!");
  tft.setTextColor(ILI9341_WHITE, ILI9341_RED);
  tft.setTextSize(2);
  tft.println(1234.56);
  tft.setTextColor(ILI9341_GREEN);
  tft.print(0xDEADBEEFUL, HEX);
  tft.print(' ');
  tft.println(-42);
}
