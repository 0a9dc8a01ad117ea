// SPDX-License-Identifier: GPL-2.0-or-later
// FOR_EACH_PROCESSOR: the function is compiled for AVX-512, for AVX2 and for any x86-64, and the processor
// decides; its file is compiled without fused multiply-add, so that all give the same. Clang does not clone
// templates, and other processors have one set of instructions for all.
#pragma once

#if defined(__clang__) || !defined(__x86_64__)
#define FOR_EACH_PROCESSOR __attribute__((flatten))
#else
#define FOR_EACH_PROCESSOR __attribute__((flatten, target_clones("arch=x86-64-v4", "avx2", "default")))
#endif
