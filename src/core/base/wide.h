/* ARC_WIDE marks a function that consists of loops over arrays. The function is compiled for
 * AVX-512, for AVX2 and for any processor, and the program selects the fastest usable version when
 * it starts. All versions give identical results, as no multiplication and addition are fused and
 * every sum keeps its order. With ARC_NARROW the function is compiled once, as tests run only one
 * version and the others would count as uncovered lines. */
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
