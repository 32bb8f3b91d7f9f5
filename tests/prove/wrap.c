/* wp: etch_wrap_add,etch_wrap_sub,etch_wrap_mul
 * flags: -no-warn-unsigned-overflow
 * proved: the helpers called wrap add, subtract and multiply modulo 2^32
 * assumed: nothing */
#include "prove.h"
#include "core/base/fixed.h"

void prove(void)
{
    (void)etch_wrap_add(ANY_U32, ANY_U32);
    (void)etch_wrap_sub(ANY_U32, ANY_U32);
    (void)etch_wrap_mul(ANY_U32, ANY_U32);
}
