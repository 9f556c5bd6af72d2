/* Random ticks and a hash of what comes out, the same here and in equal/src/main.rs. */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>
#include <string.h>

static uint64_t random_state = 1;
static uint64_t hash_state;

static uint64_t random_bits(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

/* From -1 to 1. */
static double random_unit(void)
{
    return (double)(int64_t)random_bits() / 9223372036854775808.0;
}

/* Mostly a number up to `most`, at times something that no device should tell. */
static double random_number(double most)
{
    static const uint64_t hostile[4] = { 0, 0x7ff0000000000000u, 0xfff0000000000000u, 0x7ff8000000000000u };
    uint64_t chance = random_bits() >> 50;
    double number;

    if (chance >= 20) {
        return most * random_unit();
    }
    if (chance >= 16) {
        return 1e30 * random_unit();
    }
    memcpy(&number, &hostile[chance % 4], sizeof number);
    return number;
}

static double random_period(void)
{
    return random_bits() >> 56 == 0 ? random_number(1e-3) : 1e-3 * (1.0 + 0.25 * random_unit());
}

/* Whether a signal is 0 on all axes, as at rest and in free motion. */
static int random_rest(void)
{
    return random_bits() >> 61 == 0;
}

static void hash_bits(uint64_t bits)
{
    int at;

    for (at = 0; at < 8; ++at) {
        hash_state = (hash_state ^ (bits & 0xff)) * 0x100000001b3u;
        bits >>= 8;
    }
}

/* A NaN counts as one, whatever its other bits. */
static void hash_number(double number)
{
    uint64_t bits;

    memcpy(&bits, &number, sizeof bits);
    hash_bits(number == number ? bits : 0x7ff8000000000000u);
}

/* The largest numbers of a sample's fields: m, m/s, m, N, J. */
static const double random_most[5] = { 0.01, 0.5, 5e-4, 10.0, 5e-3 };

#endif
