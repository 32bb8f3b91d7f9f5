// A sketch for TFT_eSPI, of which only the includes are changed:
//   #include <SPI.h>
//   #include <TFT_eSPI.h>
#include "ports/familiar/gfx.hpp"
#include <math.h>

TFT_eSPI tft = TFT_eSPI();

#define TFT_GREY 0x5AEB

static uint16_t swatch[32 * 16];
int hours = 10, minutes = 9;

void setup(void) {
  tft.init();
  tft.setRotation(1);
  tft.setSwapBytes(true);
  for (int i = 0; i < 32 * 16; i++)
    swatch[i] = tft.color565(i % 32 * 8, i / 32 * 16, 128);
}

int16_t across(int angle, int length) { return (int16_t)(cos((angle - 90) * 0.0174532925) * length); }
int16_t down(int angle, int length) { return (int16_t)(sin((angle - 90) * 0.0174532925) * length); }

void hand(int angle, int length, int width, uint16_t color) {
  tft.drawWideLine(120, 120, 120 + across(angle, length), 120 + down(angle, length), width, color);
}

void loop() {
  tft.fillScreen(TFT_BLACK);
  tft.fillSmoothCircle(120, 120, 118, TFT_GREY, TFT_BLACK);
  tft.fillSmoothCircle(120, 120, 110, TFT_BLACK);
  for (int i = 0; i < 360; i += 30) {
    tft.drawLine(120 + across(i, 98), 120 + down(i, 98), 120 + across(i, 108), 120 + down(i, 108), TFT_WHITE);
    tft.fillCircle(120 + across(i, 90), 120 + down(i, 90), i % 90 == 0 ? 4 : 2, TFT_GOLD);
  }
  tft.drawArc(120, 120, 80, 74, 180, 210, TFT_SKYBLUE, TFT_BLACK);
  hand(hours * 30 + minutes / 2, 52, 7, TFT_WHITE);
  hand(minutes * 6, 76, 5, TFT_LIGHTGREY);
  hand(210, 84, 2, TFT_RED);
  tft.fillSmoothCircle(120, 120, 6, TFT_RED);

  tft.fillSmoothRoundRect(246, 10, 66, 40, 8, TFT_NAVY);
  tft.setTextColor(TFT_WHITE);
  tft.setTextSize(2);
  tft.setTextDatum(MC_DATUM);
  tft.drawString("10:09", 279, 30);
  tft.setTextSize(1);
  tft.setTextDatum(TR_DATUM);
  tft.setTextColor(TFT_GREEN, TFT_DARKGREY);
  tft.drawString("Mon 23 Nov", 312, 60);
  tft.pushImage(262, 90, 32, 16, swatch);
  tft.pushImage(262, 120, 32, 16, swatch, swatch[40]);
  tft.drawEllipse(278, 170, 30, 12, TFT_PINK);
  tft.fillEllipse(278, 170, 20, 6, TFT_VIOLET);
  if (tft.readPixel(278, 170) == TFT_VIOLET)
    tft.drawPixel(278, 170, TFT_WHITE);
}
