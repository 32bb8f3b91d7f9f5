/* vertex/projection.c: perspective and parallel projection. Called by the application once a
 * frame or less. See matrix.h. */
#include "../base/trig.h"
#include "matrix.h"

/* *entry = n / d, rounded to nearest; false where that does not fit. The two extreme values
 * count as too large. |n| < 2^63, d != 0. */
static bool set_quotient(etch_q16 *entry, int64_t n, int64_t d)
{
    *entry = etch_divide_round_s64(n, d);
    return *entry != INT32_MAX && *entry != INT32_MIN;
}

static int64_t sum(etch_q16 a, etch_q16 b)
{
    return (int64_t)a + b;
}

static int64_t span(etch_q16 from, etch_q16 to)
{
    return (int64_t)to - from;
}

/* Rows 2 and 3 of a perspective: z = -near to -w, z = -far to w. 2 * far * near < 2^63. */
static bool set_depth(struct etch_matrix *m, etch_q16 near, etch_q16 far)
{
    m->m[3][2] = -ETCH_Q16_ONE;
    m->m[3][3] = 0;
    return set_quotient(&m->m[2][2], sum(near, far) * 65536, -span(near, far)) &&
           set_quotient(&m->m[2][3], 2 * etch_mul_s32(near, far), -span(near, far));
}

enum etch_status etch_matrix_perspective_focal(struct etch_matrix *m, etch_q16 focal,
                                               etch_q16 aspect, etch_q16 near, etch_q16 far)
{
    struct etch_matrix p;

    if (focal <= 0 || aspect <= 0 || near <= 0 || far <= near)
        return ETCH_EINVAL;
    etch_matrix_scale(&p, 0, focal, 0);
    if (!set_quotient(&p.m[0][0], (int64_t)focal * 65536, aspect) || !set_depth(&p, near, far))
        return ETCH_ERANGE;
    *m = p;
    return ETCH_OK;
}

enum etch_status etch_matrix_perspective(struct etch_matrix *m, uint16_t fov, etch_q16 aspect,
                                         etch_q16 near, etch_q16 far)
{
    const int64_t one_q30 = INT64_C(1) << 30;
    const int64_t sine = etch_sin_q30(fov);
    const int64_t cosine = etch_cos_q30(fov);
    etch_q16 focal;

    if (fov == 0 || fov >= 0x8000)
        return ETCH_EINVAL;
    /* cot(fov / 2), by the form whose divisor does not cancel; at most 20861. */
    if (fov <= 0x4000)
        focal = etch_divide_round_s64((one_q30 + cosine) * 65536, sine);
    else
        focal = etch_divide_round_s64(sine * 65536, one_q30 - cosine);
    return etch_matrix_perspective_focal(m, focal, aspect, near, far);
}

static bool is_box(const struct etch_box *box)
{
    return box->left != box->right && box->bottom != box->top && box->near < box->far;
}

enum etch_status etch_matrix_frustum(struct etch_matrix *m, const struct etch_box *box)
{
    const int64_t width = span(box->left, box->right);
    const int64_t height = span(box->bottom, box->top);
    struct etch_matrix p;

    if (!is_box(box) || box->near <= 0)
        return ETCH_EINVAL;
    etch_matrix_scale(&p, 0, 0, 0);
    if (!set_quotient(&p.m[0][0], sum(box->near, box->near) * 65536, width) ||
        !set_quotient(&p.m[0][2], sum(box->right, box->left) * 65536, width) ||
        !set_quotient(&p.m[1][1], sum(box->near, box->near) * 65536, height) ||
        !set_quotient(&p.m[1][2], sum(box->top, box->bottom) * 65536, height) ||
        !set_depth(&p, box->near, box->far))
        return ETCH_ERANGE;
    *m = p;
    return ETCH_OK;
}

enum etch_status etch_matrix_orthographic(struct etch_matrix *m, const struct etch_box *box)
{
    const int64_t two_q32 = INT64_C(2) << 32;
    const int64_t width = span(box->left, box->right);
    const int64_t height = span(box->bottom, box->top);
    const int64_t depth = span(box->near, box->far);
    struct etch_matrix p;

    if (!is_box(box))
        return ETCH_EINVAL;
    etch_matrix_identity(&p);
    if (!set_quotient(&p.m[0][0], two_q32, width) ||
        !set_quotient(&p.m[0][3], sum(box->right, box->left) * 65536, -width) ||
        !set_quotient(&p.m[1][1], two_q32, height) ||
        !set_quotient(&p.m[1][3], sum(box->top, box->bottom) * 65536, -height) ||
        !set_quotient(&p.m[2][2], two_q32, -depth) ||
        !set_quotient(&p.m[2][3], sum(box->far, box->near) * 65536, -depth))
        return ETCH_ERANGE;
    *m = p;
    return ETCH_OK;
}
