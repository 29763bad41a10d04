/* ARC_WIDE marks a function that consists of loops over arrays. The function is compiled for
 * AVX-512, for AVX2 and for any processor, and the fastest usable version is selected when the
 * program starts. All versions have identical results, because multiplications and additions are
 * not fused and the order of each sum is fixed. With ARC_NARROW, for measuring test coverage, the
 * function is compiled once. */
#ifndef BASE_WIDE_H
#define BASE_WIDE_H

#include <stdlib.h> /* defines __GLIBC__ if the C library is glibc, which selects the version */

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(ARC_NARROW)
#define ARC_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ARC_WIDE
#endif

/* ARC_UNROLL, before a loop of at most 16 passes, unrolls the loop, so that arrays of this length
 * remain in registers. */
#if defined(__GNUC__) && !defined(__clang__)
#define ARC_UNROLL _Pragma("GCC unroll 16")
#else
#define ARC_UNROLL
#endif

#endif
