/* ports/familiar/gfx.hpp: Adafruit GFX and TFT_eSPI for sketches in C++: include this instead of
 * their headers, and of those of the display's driver. The methods are those of gfx.h and its
 * neighbours, which say what they draw; README.md has the list and the differences. C++11, no
 * library, no heap.
 *
 *      #include "ports/familiar/gfx.hpp"
 *      TFT_eSPI tft;                          or Adafruit_ILI9341 tft(CS, DC);
 *      void setup() { tft.begin(); tft.fillScreen(TFT_BLACK); .. }
 *
 * The program that calls setup and loop gives them what to draw on:
 *
 *      tft.surface = *etch_frame_begin(&frame); */
#ifndef ETCH_PORTS_FAMILIAR_GFX_HPP
#define ETCH_PORTS_FAMILIAR_GFX_HPP

#include "gfx_colors.h"
#include "gfx_images.h"
#include "gfx_shapes.h"
#include "gfx_smooth.h"
#include "gfx_text.h"

#ifndef GFX_WIDTH
#define GFX_WIDTH 240 /* of the panel at rotation 0 */
#endif
#ifndef GFX_HEIGHT
#define GFX_HEIGHT 320
#endif

enum gfx_base { DEC = 10, HEX = 16, OCT = 8, BIN = 2 };

/* What both libraries have. */
class Adafruit_GFX : public gfx
{
  public:
    typedef int16_t i16;
    typedef uint16_t u16;

    Adafruit_GFX(i16 width, i16 height) { gfx_begin(this, width, height, GFX_HIGH_BYTE_LAST); }

    i16 width() const { return gfx_width(this); }
    i16 height() const { return gfx_height(this); }
    uint8_t getRotation() const { return gfx_getRotation(this); }
    void setRotation(uint8_t quarters) { gfx_setRotation(this, quarters); }
    static u16 color565(uint8_t r, uint8_t g, uint8_t b) { return gfx_color565(r, g, b); }
    void startWrite() {}
    void endWrite() {}

    void drawPixel(i16 x, i16 y, u16 c) { gfx_drawPixel(this, x, y, c); }
    void writePixel(i16 x, i16 y, u16 c) { gfx_drawPixel(this, x, y, c); }
    void drawLine(i16 x0, i16 y0, i16 x1, i16 y1, u16 c) { gfx_drawLine(this, x0, y0, x1, y1, c); }
    void drawFastHLine(i16 x, i16 y, i16 w, u16 c) { gfx_drawFastHLine(this, x, y, w, c); }
    void drawFastVLine(i16 x, i16 y, i16 h, u16 c) { gfx_drawFastVLine(this, x, y, h, c); }
    void drawRect(i16 x, i16 y, i16 w, i16 h, u16 c) { gfx_drawRect(this, x, y, w, h, c); }
    void fillRect(i16 x, i16 y, i16 w, i16 h, u16 c) { gfx_fillRect(this, x, y, w, h, c); }
    void fillScreen(u16 c) { gfx_fillScreen(this, c); }

    void drawCircle(i16 x, i16 y, i16 r, u16 c) { gfx_drawCircle(this, x, y, r, c); }
    void fillCircle(i16 x, i16 y, i16 r, u16 c) { gfx_fillCircle(this, x, y, r, c); }
    void drawEllipse(i16 x, i16 y, i16 rx, i16 ry, u16 c)
    {
        gfx_drawEllipse(this, x, y, rx, ry, c);
    }
    void fillEllipse(i16 x, i16 y, i16 rx, i16 ry, u16 c)
    {
        gfx_fillEllipse(this, x, y, rx, ry, c);
    }
    void drawRoundRect(i16 x, i16 y, i16 w, i16 h, i16 r, u16 c)
    {
        gfx_drawRoundRect(this, x, y, w, h, r, c);
    }
    void fillRoundRect(i16 x, i16 y, i16 w, i16 h, i16 r, u16 c)
    {
        gfx_fillRoundRect(this, x, y, w, h, r, c);
    }
    void drawTriangle(i16 x0, i16 y0, i16 x1, i16 y1, i16 x2, i16 y2, u16 c)
    {
        gfx_drawTriangle(this, x0, y0, x1, y1, x2, y2, c);
    }
    void fillTriangle(i16 x0, i16 y0, i16 x1, i16 y1, i16 x2, i16 y2, u16 c)
    {
        gfx_fillTriangle(this, x0, y0, x1, y1, x2, y2, c);
    }

    void drawBitmap(i16 x, i16 y, const uint8_t *bits, i16 w, i16 h, u16 c)
    {
        gfx_drawBitmap(this, x, y, bits, w, h, c);
    }
    void drawBitmap(i16 x, i16 y, const uint8_t *bits, i16 w, i16 h, u16 c, u16 background)
    {
        gfx_drawBitmapOn(this, x, y, bits, w, h, c, background);
    }
    void drawXBitmap(i16 x, i16 y, const uint8_t *bits, i16 w, i16 h, u16 c)
    {
        gfx_drawXBitmap(this, x, y, bits, w, h, c);
    }
    void drawRGBBitmap(i16 x, i16 y, const u16 *colors, i16 w, i16 h)
    {
        gfx_drawRGBBitmap(this, x, y, colors, w, h);
    }

    void setCursor(i16 x, i16 y) { gfx_setCursor(this, x, y); }
    i16 getCursorX() const { return cursor_x; }
    i16 getCursorY() const { return cursor_y; }
    void setTextSize(uint8_t size) { gfx_setTextSize(this, size); }
    void setTextColor(u16 c) { gfx_setTextColor(this, c); }
    void setTextColor(u16 c, u16 background) { gfx_setTextColorOn(this, c, background); }
    void setTextWrap(bool ends) { gfx_setTextWrap(this, ends); }
    void drawChar(i16 x, i16 y, unsigned char c, u16 color, u16 background, uint8_t size)
    {
        gfx_drawChar(this, x, y, c, color, background, size, size);
    }
    void getTextBounds(const char *text, i16 x, i16 y, i16 *x1, i16 *y1, u16 *w, u16 *h) const
    {
        gfx_getTextBounds(this, text, x, y, x1, y1, w, h);
    }

    void write(uint8_t c) { gfx_write(this, (char)c); }
    void print(const char *text) { gfx_print(this, text); }
    void print(char c) { gfx_write(this, c); }
    void print(int value, int base = DEC) { print((long)value, base); }
    void print(unsigned value, int base = DEC) { print((unsigned long)value, base); }
    void print(long value, int base = DEC) { gfx_printNumber(this, (int32_t)value, (uint8_t)base); }
    void print(unsigned long value, int base = DEC)
    {
        if (base == DEC && value > INT32_MAX) /* the last digit apart: it fits 31 bits */
            gfx_printNumber(this, (int32_t)(value / 10), DEC), value %= 10;
        gfx_printNumber(this, (int32_t)value, (uint8_t)base);
    }
    void print(double value, int places = 2);
    void println() { gfx_write(this, '\n'); }
    template <class T> void println(T value) { print(value), println(); }
    template <class T> void println(T value, int how) { print(value, how), println(); }
};

/* Rounded to `places` digits behind the point, ties away from 0; |value| below 2^32. Linked only
 * where a sketch prints such numbers. */
inline void Adafruit_GFX::print(double value, int places)
{
    double half = 0.5;

    if (value < 0) {
        print('-');
        value = -value;
    }
    for (int i = 0; i < places; i++)
        half /= 10;
    value += half;
    print((unsigned long)value);
    if (places > 0)
        print('.');
    for (value -= (double)(unsigned long)value; places > 0; places--) {
        value *= 10;
        print((int)value);
        value -= (int)value;
    }
}

/* Pins and buses are the board's affair: any are taken. */
class Adafruit_ILI9341 : public Adafruit_GFX
{
  public:
    template <class... Pins>
    explicit Adafruit_ILI9341(Pins...) : Adafruit_GFX(GFX_WIDTH, GFX_HEIGHT)
    {
    }
    void begin(uint32_t = 0) {}
};

class TFT_eSPI : public Adafruit_GFX
{
  public:
    explicit TFT_eSPI(i16 width = GFX_WIDTH, i16 height = GFX_HEIGHT) : Adafruit_GFX(width, height)
    {
    }
    void begin() {}
    void init() {}

    u16 readPixel(i16 x, i16 y) const { return gfx_readPixel(this, x, y); }
    void setSwapBytes(bool swap) { gfx_setSwapBytes(this, swap); }
    void pushImage(i16 x, i16 y, i16 w, i16 h, const u16 *data)
    {
        gfx_pushImage(this, x, y, w, h, data);
    }
    void pushImage(i16 x, i16 y, i16 w, i16 h, const u16 *data, u16 transparent)
    {
        gfx_pushImageKey(this, x, y, w, h, data, transparent);
    }

    void setTextDatum(uint8_t at) { gfx_setTextDatum(this, at); }
    i16 textWidth(const char *text) const { return gfx_textWidth(this, text); }
    i16 fontHeight() const { return gfx_fontHeight(this); }
    i16 drawString(const char *text, i16 x, i16 y) { return gfx_drawString(this, text, x, y); }

    void fillSmoothCircle(i16 x, i16 y, i16 r, u16 c, u16 = 0)
    {
        gfx_fillSmoothCircle(this, x, y, r, c, cover);
    }
    void drawSmoothCircle(i16 x, i16 y, i16 r, u16 c, u16 = 0)
    {
        gfx_drawSmoothCircle(this, x, y, r, c, cover);
    }
    void fillSmoothRoundRect(i16 x, i16 y, i16 w, i16 h, i16 r, u16 c, u16 = 0)
    {
        gfx_fillSmoothRoundRect(this, x, y, w, h, r, c, cover);
    }
    void drawArc(i16 x, i16 y, i16 outer, i16 inner, u16 start, u16 end, u16 c, u16 = 0,
                 bool = true)
    {
        gfx_drawArc(this, x, y, outer, inner, start, end, c, cover);
    }
    void drawWideLine(i16 ax, i16 ay, i16 bx, i16 by, i16 wide, u16 c, u16 = 0)
    {
        gfx_drawWideLine(this, ax, ay, bx, by, wide * INT32_C(256), c, cover);
    }

  private:
    int16_t cover[(GFX_WIDTH > GFX_HEIGHT ? GFX_WIDTH : GFX_HEIGHT) + 1];
};

#endif
