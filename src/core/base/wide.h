/* ARC_WIDE before a function that is a loop over arrays: compiled once more for each kind of wider
 * registers, of which the program takes the widest there is as it starts. The bits stay the same:
 * nothing is contracted, and every sum keeps its order. With ARC_NARROW it is compiled once: what
 * is for other processors does not run here, and would count as not reached. */
#ifndef BASE_WIDE_H
#define BASE_WIDE_H

#include <stdlib.h> /* tells whether this is glibc, which chooses */

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(ARC_NARROW)
#define ARC_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define ARC_WIDE
#endif

#endif
