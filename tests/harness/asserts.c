/* tests/harness: where a failed ETCH_ASSERT of core ends up. See stores.h. */
#include "assert.h"

#include <setjmp.h>
#include <stddef.h>

#include "harness.h"
#include "stores.h"

static jmp_buf *caller; /* of the call that may trip one, or NULL */

void test_assert_failed(const char *condition, const char *file)
{
    if (caller != NULL)
        longjmp(*caller, 1);
    test_write("FAIL ");
    test_write(file);
    test_write(": ETCH_ASSERT(");
    test_write(condition);
    test_write(")\n");
    __builtin_trap();
}

bool test_trips(void (*call)(void))
{
    jmp_buf here;

    caller = &here;
    if (setjmp(here) == 0) {
        call();
        caller = NULL;
        return false;
    }
    caller = NULL;
    return true;
}
