/* What each block refuses: pointers that lead nowhere, storage that is not its own, and a memory that none can have. */
#ifndef REFUSES_H
#define REFUSES_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <lyapunov.h>

static void expected(lyapunov_code code, lyapunov_code wanted, const char *name)
{
    if (code != wanted) {
        printf("%s: code %lu, and %lu is right\n", name, (unsigned long)code, (unsigned long)wanted);
        exit(1);
    }
}

#define AT_ONE_BYTE_MORE(it) ((void *)((char *)&(it) + 1))

/* That a refused call changed nothing shows in the hash, which then is not Rust's. */
#define REFUSES(block, signal)                                       \
    do {                                                             \
        lyapunov_##block##_##signal##_memory memory_;                \
        expected(lyapunov_##block##_##signal##_init(NULL, &parameters).code, LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_init(&storage, NULL).code, LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_init(AT_ONE_BYTE_MORE(storage), &parameters).code, LYAPUNOV_MISALIGNED, #block); \
        expected(lyapunov_##block##_##signal##_retune(NULL, &parameters).code, LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_save(NULL, &memory_), LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_save(&storage, NULL), LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_restore(&storage, NULL).code, LYAPUNOV_NULL, #block); \
        storage.tag ^= 1;                                            \
        expected(lyapunov_##block##_##signal##_retune(&storage, &parameters).code, LYAPUNOV_NOT_INITIALISED, #block); \
        expected(lyapunov_##block##_##signal##_save(&storage, &memory_), LYAPUNOV_NOT_INITIALISED, #block); \
        storage.tag ^= 1;                                            \
        memset(&memory_, 0xff, sizeof memory_);                      \
        expected(lyapunov_##block##_##signal##_restore(&storage, &memory_).code, LYAPUNOV_MEMORY, #block "_" #signal); \
        expected(lyapunov_##block##_##signal##_save(&storage, &memory_), LYAPUNOV_OK, #block); \
        expected(lyapunov_##block##_##signal##_restore(&storage, &memory_).code, LYAPUNOV_OK, #block); \
        expected(lyapunov_##block##_##signal##_retune(&storage, &parameters).code, LYAPUNOV_OK, #block); \
    } while (0)

#define STEP_REFUSES(block, signal)                                  \
    do {                                                             \
        memset(&sample, 0, sizeof sample);                           \
        memset(&effort, 0, sizeof effort);                           \
        expected(lyapunov_##block##_##signal##_step(NULL, &sample, GIVEN_##signal(effort), &correction), LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_step(&storage, NULL, GIVEN_##signal(effort), &correction), LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_step(&storage, &sample, GIVEN_##signal(effort), NULL), LYAPUNOV_NULL, #block); \
        expected(lyapunov_##block##_##signal##_step(&storage, AT_ONE_BYTE_MORE(sample), GIVEN_##signal(effort), &correction), LYAPUNOV_MISALIGNED, #block); \
        storage.tag ^= 1;                                            \
        expected(lyapunov_##block##_##signal##_step(&storage, &sample, GIVEN_##signal(effort), &correction), LYAPUNOV_NOT_INITIALISED, #block); \
        storage.tag ^= 1;                                            \
    } while (0)

#endif
