/* ARC_WIDE marks a function that is a loop over arrays. The function is compiled for each kind of
 * wider registers, and the program selects the widest available version when it starts. All
 * versions give the same bits, as no operations are contracted and every sum keeps its order. With
 * ARC_NARROW the function is compiled once, since versions for other processors do not run in tests
 * and would count as uncovered lines. */
#ifndef BASE_WIDE_H
#define BASE_WIDE_H

#include <stdlib.h> /* defines __GLIBC__ if the C library is glibc, which selects the version */

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(ARC_NARROW)
#define ARC_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ARC_WIDE
#endif

#endif
