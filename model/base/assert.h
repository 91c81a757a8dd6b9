#pragma once

#include <cstdio>
#include <cstdlib>

/// States an invariant of our own code. A violated one is a bug in Copperscope, never bad input: it prints and aborts.
/// Active unless COPPERSCOPE_NO_ASSERT is defined (the release preset keeps it: the tests are cheap compared with a
/// wrong answer).
#ifdef COPPERSCOPE_NO_ASSERT
#define ASSERT(cond) ((void)0)
#else
#define ASSERT(cond)                                                                          \
    do {                                                                                      \
        if (!(cond)) {                                                                        \
            std::fprintf(stderr, "%s:%d: assertion failed: %s\n", __FILE__, __LINE__, #cond); \
            std::abort();                                                                     \
        }                                                                                     \
    } while (false)
#endif
