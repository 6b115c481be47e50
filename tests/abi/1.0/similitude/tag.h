/*
 * What a library says about itself before it is loaded, for C and C++ alike. C++ authors get it with plugin.h; authors in
 * other languages write, once per library and at file scope,
 *
 *   SIMILITUDE_TAG(my_tag);
 *   SIMILITUDE_EXPORT const similitude_entry similitude_plugin = {sizeof(similitude_entry), 1, &my_tag, my_models};
 */
#ifndef SIMILITUDE_TAG_H
#define SIMILITUDE_TAG_H

#include <similitude/abi.h>

#define SIMILITUDE_EXPORT __attribute__((visibility("default")))

#if defined(__clang__)
#define SIMILITUDE_COMPILER "clang " __clang_version__
#elif defined(__GNUC__)
#define SIMILITUDE_COMPILER "gcc " __VERSION__
#else
#define SIMILITUDE_COMPILER "unknown"
#endif

/* The least level that has all vector instructions this file is compiled for. */
#if defined(__AVX512F__)
#define SIMILITUDE_INSTRUCTION_SET "x86-64-v4"
#elif defined(__AVX__) || defined(__AVX2__) || defined(__FMA__) || defined(__BMI__) || defined(__BMI2__)
#define SIMILITUDE_INSTRUCTION_SET "x86-64-v3"
#elif defined(__SSE3__) || defined(__SSSE3__) || defined(__SSE4_1__) || defined(__SSE4_2__) || defined(__POPCNT__)
#define SIMILITUDE_INSTRUCTION_SET "x86-64-v2"
#elif defined(__x86_64__)
#define SIMILITUDE_INSTRUCTION_SET "x86-64"
#elif defined(__aarch64__)
#define SIMILITUDE_INSTRUCTION_SET "aarch64"
#else
#define SIMILITUDE_INSTRUCTION_SET "unknown"
#endif

#define SIMILITUDE_TAG(name)                                                                              \
  __attribute__((section(SIMILITUDE_TAG_SECTION), used)) static const similitude_tag name = {             \
      SIMILITUDE_TAG_MAGIC, sizeof(similitude_tag), SIMILITUDE_ABI_MAJOR,       SIMILITUDE_ABI_MINOR,     \
      SIMILITUDE_LAYOUT_HASH, 0,                    SIMILITUDE_COMPILER,        SIMILITUDE_INSTRUCTION_SET}

#endif
