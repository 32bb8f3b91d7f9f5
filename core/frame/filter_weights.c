/* frame/filter_weights.c: the usual 3 x 3 kernels. Given to etch_filter_draw by applications. See
 * filter.h. */
#include "filter.h"

const struct etch_filter_weights etch_filter_weights_average = {{1, 1, 1, 1, 1, 1, 1, 1, 1}, 9, 0};
const struct etch_filter_weights etch_filter_weights_blur = {{1, 2, 1, 2, 4, 2, 1, 2, 1}, 16, 0};
const struct etch_filter_weights etch_filter_weights_sharpen = {
    {0, -1, 0, -1, 5, -1, 0, -1, 0}, 1, 0};
const struct etch_filter_weights etch_filter_weights_laplace = {
    {-1, -1, -1, -1, 8, -1, -1, -1, -1}, 1, 0};
const struct etch_filter_weights etch_filter_weights_emboss = {
    {-2, -1, 0, -1, 0, 1, 0, 1, 2}, 2, 128};
const struct etch_filter_weights etch_filter_weights_identity = {{0, 0, 0, 0, 1, 0, 0, 0, 0}, 1, 0};
