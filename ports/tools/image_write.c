/* ports/tools/image_write.c: writes images as C. Called by etch-image. See image_format.h. */
#include "../../core/base/rgb565.h"
#include "image_format.h"

/* What is written where to. */
struct writing {
    FILE *out;
    const char *name;
    const struct packed *packed;
    const struct image_options *options;
};

static uint16_t ordered(const struct writing *w, uint16_t color)
{
    return w->options->swapped ? etch_rgb565_swap(color) : color;
}

static void begin(const struct writing *w, const char *type, const char *what)
{
    fprintf(w->out, "static const %s %s_%s[] = {", type, w->name, what);
}

static void write_bytes(const struct writing *w, const struct plane *plane, const char *what)
{
    begin(w, "uint8_t", what);
    for (size_t i = 0; i < plane->size; i++)
        fprintf(w->out, "%s%d,", i % 24 == 0 ? "\n    " : "", plane->bytes[i]);
    fprintf(w->out, "\n};\n\n");
}

static void write_words(const struct writing *w, const struct plane *plane)
{
    begin(w, "uint16_t", "texels");
    for (size_t i = 0; i < plane->size / 2; i++)
        fprintf(w->out, "%s0x%04X,", i % 12 == 0 ? "\n    " : "",
                plane->bytes[2 * i] | plane->bytes[2 * i + 1] << 8);
    fprintf(w->out, "\n};\n\n");
}

static void write_palette(const struct writing *w)
{
    begin(w, "uint16_t", "palette");
    for (int i = 0; i < w->packed->colors; i++)
        fprintf(w->out, "%s0x%04X,", i % 12 == 0 ? "\n    " : "",
                ordered(w, w->packed->palette[i]));
    fprintf(w->out, "\n};\n\n");
}

static void write_rows(const struct writing *w, const struct plane *plane, const char *what)
{
    const int count = ((w->packed->height - 1) >> w->options->rows_shift) + 1;

    begin(w, "uint32_t", what);
    for (int i = 0; i < count; i++)
        fprintf(w->out, "%s%lu,", i % 12 == 0 ? "\n    " : "", (unsigned long)plane->rows[i]);
    fprintf(w->out, "\n};\n\n");
}

/* The members of struct etch_image. */
static void write_image(const struct writing *w, const char *indent, bool planes)
{
    const struct packed *const p = w->packed;
    const bool mask = p->format->kind == IMAGE_MASK;

    if (w->options->sampled)
        fprintf(w->out, "%s.colors = %s,\n", indent, p->format->colors);
    if (w->options->sampled && p->format->alphas != NULL)
        fprintf(w->out, "%s.alphas = %s,\n", indent, p->format->alphas);
    if (planes)
        fprintf(w->out, "%s.texels = %s_%s,\n", indent, w->name, mask ? "alpha" : "texels");
    if (p->colors != 0)
        fprintf(w->out, "%s.palette = %s_palette,\n", indent, w->name);
    if (planes && p->alpha.size != 0)
        fprintf(w->out, "%s.alpha = %s_alpha,\n", indent, w->name);
    else if (planes && w->options->sampled && p->format->alphas != NULL)
        fprintf(w->out, "%s.alpha = (const uint8_t *)%s_texels, /* not read */\n", indent, w->name);
    fprintf(w->out, "%s.width = %d,\n%s.height = %d,\n%s.stride = %d,\n", indent, p->width, indent,
            p->height, indent, p->stride);
}

static void write_plane(const struct writing *w, const struct plane *plane, const char *what,
                        int bits)
{
    if (plane->size == 0)
        return;
    fprintf(w->out, "    .%s =\n        {\n            .decode = etch_rle_%s,\n", what,
            plane->unit_size == 2 ? "words" : "bytes");
    fprintf(w->out, "            .data = %s_%s,\n            .rows = %s_%s_rows,\n", w->name, what,
            w->name, what);
    fprintf(w->out, "            .size = %lu,\n            .units = %d,\n",
            (unsigned long)plane->size, plane->pitch / plane->unit_size);
    fprintf(w->out, "            .unit_size = %d,\n            .per_unit = %d,\n", plane->unit_size,
            bits < 8 ? 8 / bits : 1);
    fprintf(w->out, "            .rows_shift = %d,\n        },\n", w->options->rows_shift);
}

static void write_compressed(const struct writing *w)
{
    const struct packed *const p = w->packed;
    const int bits = p->format->bits;

    if (p->texels.size != 0) {
        write_bytes(w, &p->texels, "texels");
        write_rows(w, &p->texels, "texels_rows");
    }
    if (p->alpha.size != 0) {
        write_bytes(w, &p->alpha, "alpha");
        write_rows(w, &p->alpha, "alpha_rows");
    }
    fprintf(w->out, "const struct etch_rle_image %s = {\n    .image =\n        {\n", w->name);
    write_image(w, "            ", false);
    fprintf(w->out, "        },\n");
    write_plane(w, &p->texels, "texels", bits);
    write_plane(w, &p->alpha, "alpha", bits == 4 ? 4 : 8);
    fprintf(w->out, "};\n");
}

void image_write(FILE *out, const struct packed *packed, const struct image_options *options,
                 const char *name, const char *core, const char *from)
{
    const struct writing w = {out, name, packed, options};

    fprintf(out, "/* %s */\n#include \"%s/draw/%s.h\"\n", from, core,
            options->compressed ? "image_rle" : "image");
    if (options->sampled)
        fprintf(out, "#include \"%s/fragment/sampler.h\"\n", core);
    fprintf(out,
            "\n/* clang-format off */\n\n/* %d x %d, %s%s; %lu bytes. Rows: %s */\nextern const "
            "struct etch_%s %s;\n\n",
            packed->width, packed->height, packed->format->name,
            options->swapped ? ", byte-swapped" : "", (unsigned long)image_size(packed, options),
            packed->format->row, options->compressed ? "rle_image" : "image", name);
    if (packed->colors != 0)
        write_palette(&w);
    if (options->compressed) {
        write_compressed(&w);
        return;
    }
    if (packed->texels.size != 0 && packed->format->bits == 16)
        write_words(&w, &packed->texels);
    else if (packed->texels.size != 0)
        write_bytes(&w, &packed->texels, "texels");
    if (packed->alpha.size != 0)
        write_bytes(&w, &packed->alpha, "alpha");
    fprintf(out, "const struct etch_image %s = {\n", name);
    write_image(&w, "    ", true);
    fprintf(out, "};\n");
}
