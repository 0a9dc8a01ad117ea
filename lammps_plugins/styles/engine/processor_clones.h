// SPDX-License-Identifier: GPL-2.0-or-later
// FOR_EACH_PROCESSOR: compiles a function for AVX-512, AVX2 and baseline x86-64, selected at run time. Its
// file is compiled without fused multiply-add, so that all variants give the same bits. Not used with Clang,
// which does not clone templates, nor on other architectures, which need no variants.
#pragma once

#if defined(__clang__) || !defined(__x86_64__)
#define FOR_EACH_PROCESSOR __attribute__((flatten))
#else
#define FOR_EACH_PROCESSOR __attribute__((flatten, target_clones("arch=x86-64-v4", "avx2", "default")))
#endif
