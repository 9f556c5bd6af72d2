/* Ticks of each group of functions, over a block on a signal. */
#ifndef TICKS_H
#define TICKS_H

#include <stdio.h>
#include <stdlib.h>

#include <lyapunov.h>

#include "random.h"
#include "refuses.h"

static unsigned long ticks = 10000;

#define GIVEN_f32(form) (form)
#define GIVEN_f64(form) (form)
#define GIVEN_f32x3(form) (&(form))
#define GIVEN_f64x3(form) (&(form))
#define GIVEN_f32x6(form) (&(form))
#define GIVEN_f64x6(form) (&(form))
#define GIVEN_f32screw(form) (&(form))
#define GIVEN_f64screw(form) (&(form))

typedef float number_f32, number_f32x3, number_f32x6, number_f32screw;
typedef double number_f64, number_f64x3, number_f64x6, number_f64screw;
typedef float lyapunov_f32;
typedef double lyapunov_f64;

#define FILL(signal, form, most)                                     \
    do {                                                             \
        number_##signal numbers[sizeof(form) / sizeof(number_##signal)]; \
        size_t at_;                                                  \
        int rest_ = random_rest();                                   \
        for (at_ = 0; at_ < sizeof numbers / sizeof numbers[0]; ++at_) { \
            numbers[at_] = rest_ ? 0 : (number_##signal)random_number(most); \
        }                                                            \
        memcpy(&(form), numbers, sizeof numbers);                    \
    } while (0)

#define HASH(signal, form)                                           \
    do {                                                             \
        number_##signal numbers[sizeof(form) / sizeof(number_##signal)]; \
        size_t at_;                                                  \
        memcpy(numbers, &(form), sizeof numbers);                    \
        for (at_ = 0; at_ < sizeof numbers / sizeof numbers[0]; ++at_) { \
            hash_number((double)numbers[at_]);                       \
        }                                                            \
    } while (0)

#define FILL_SAMPLE(signal, sample)                                  \
    do {                                                             \
        (sample).period = (number_##signal)random_period();          \
        FILL(signal, (sample).position, random_most[0]);             \
        FILL(signal, (sample).velocity, random_most[1]);             \
        FILL(signal, (sample).displacement, random_most[2]);         \
        FILL(signal, (sample).applied, random_most[3]);              \
        FILL(signal, (sample).work, random_most[4]);                 \
    } while (0)

#define HASH_SAMPLE(signal, sample)                                  \
    do {                                                             \
        hash_number((double)(sample).period);                        \
        HASH(signal, (sample).position);                             \
        HASH(signal, (sample).velocity);                             \
        HASH(signal, (sample).displacement);                         \
        HASH(signal, (sample).applied);                              \
        HASH(signal, (sample).work);                                 \
    } while (0)

#define HASH_CORRECTION(signal, correction)                          \
    do {                                                             \
        HASH(signal, (correction).effort);                           \
        hash_number((double)(correction).observed_energy);           \
        hash_number((double)(correction).alpha);                     \
        hash_number((double)(correction).shortfall);                 \
        hash_bits((correction).accepted);                            \
    } while (0)

static void begin(void)
{
    random_state = 0x9e3779b97f4a7c15u;
    hash_state = 0xcbf29ce484222325u;
}

static void checked(lyapunov_status status, const char *name)
{
    if (status.code != LYAPUNOV_OK) {
        char text[200];
        lyapunov_status_text(&status, text, sizeof text);
        printf("%s: %s\n", name, text);
        exit(1);
    }
}

static void told(const char *name)
{
    /* In halves: the C libraries of microcontrollers need not print 64 bits. */
    printf("%s %08lx%08lx\n", name, (unsigned long)(hash_state >> 32), (unsigned long)(hash_state & 0xffffffffu));
}

#define BEGIN(block, signal, ...)                                    \
    static lyapunov_##block##_##signal storage;                      \
    const lyapunov_##block##_##signal##_parameters parameters = __VA_ARGS__; \
    unsigned long tick;                                              \
    begin();                                                         \
    checked(lyapunov_##block##_##signal##_init(&storage, &parameters), #block "_" #signal); \
    REFUSES(block, signal)

/* What is called once a tick beside the step. */
#define ALONE(block, signal)
#define SIDE(block, signal)                                          \
    lyapunov_##block##_##signal##_receive(&storage, (number_##signal)random_number(0.1)); \
    hash_number((double)lyapunov_##block##_##signal##_absorbed(&storage))
#define LAYER(block, signal)                                         \
    lyapunov_##block##_##signal##_receive(&storage, (number_##signal)random_number(0.1)); \
    hash_number((double)lyapunov_##block##_##signal##_sent(&storage))

#define STABILIZER(block, signal, beside, ...)                       \
    do {                                                             \
        lyapunov_sample_##signal sample;                             \
        lyapunov_correction_##signal correction;                     \
        lyapunov_##signal effort;                                    \
        BEGIN(block, signal, __VA_ARGS__);                           \
        STEP_REFUSES(block, signal);                                 \
        for (tick = 0; tick < ticks; ++tick) {                       \
            FILL_SAMPLE(signal, sample);                             \
            FILL(signal, effort, random_most[3]);                    \
            lyapunov_##block##_##signal##_step(&storage, &sample, GIVEN_##signal(effort), &correction); \
            HASH_CORRECTION(signal, correction);                     \
            beside(block, signal);                                   \
        }                                                            \
        told(#block "_" #signal);                                    \
    } while (0)

#define CALLED(block, signal, function, ...)                         \
    do {                                                             \
        lyapunov_sample_##signal sample;                             \
        lyapunov_correction_##signal correction;                     \
        lyapunov_##signal effort;                                    \
        double context = 0.5;                                           \
        BEGIN(block, signal, __VA_ARGS__);                           \
        for (tick = 0; tick < ticks; ++tick) {                       \
            FILL_SAMPLE(signal, sample);                             \
            FILL(signal, effort, random_most[3]);                    \
            lyapunov_##block##_##signal##_step(&storage, &sample, GIVEN_##signal(effort), function, &context, &correction); \
            HASH_CORRECTION(signal, correction);                     \
        }                                                            \
        told(#block "_" #signal);                                    \
    } while (0)

#define OBSERVER(signal, ...)                                        \
    do {                                                             \
        lyapunov_sample_##signal sample;                             \
        number_##signal energy;                                      \
        BEGIN(observer, signal, __VA_ARGS__);                        \
        for (tick = 0; tick < ticks; ++tick) {                       \
            FILL_SAMPLE(signal, sample);                             \
            lyapunov_observer_##signal##_observe(&storage, &sample, &energy); \
            hash_number((double)energy);                             \
        }                                                            \
        told("observer_" #signal);                                   \
    } while (0)

#define HASH_READING(signal, seen)                                   \
    do {                                                             \
        HASH_SAMPLE(signal, (seen).sample);                          \
        hash_bits((seen).accepted + 2 * (seen).jumped + 4 * (seen).late + 8 * (seen).timed); \
    } while (0)

/* A device that moves at random, at times with a reading that is none; `call` reads. */
#define READINGS(block, signal, call, ...)                           \
    do {                                                             \
        lyapunov_checked_sample_##signal seen;                       \
        lyapunov_##signal position, velocity, applied;               \
        double now = 0.0;                                            \
        BEGIN(block, signal, __VA_ARGS__);                           \
        for (tick = 0; tick < ticks; ++tick) {                       \
            FILL(signal, position, random_most[0]);                  \
            FILL(signal, velocity, random_most[1]);                  \
            FILL(signal, applied, random_most[3]);                   \
            now += random_period();                                  \
            (void)velocity, (void)now;                               \
            call(block, signal);                                     \
            HASH_READING(signal, seen);                              \
        }                                                            \
        told(#block "_" #signal);                                    \
    } while (0)
#define READ(block, signal) \
    lyapunov_##block##_##signal##_read(&storage, GIVEN_##signal(position), GIVEN_##signal(applied), &seen)
#define READ_MOVING(block, signal) \
    lyapunov_##block##_##signal##_read_moving(&storage, GIVEN_##signal(position), GIVEN_##signal(velocity), GIVEN_##signal(applied), &seen)
#define READ_AT(block, signal) \
    lyapunov_##block##_##signal##_read_at(&storage, now, GIVEN_##signal(position), GIVEN_##signal(applied), &seen)
#define READ_MOVING_AT(block, signal) \
    lyapunov_##block##_##signal##_read_moving_at(&storage, now, GIVEN_##signal(position), GIVEN_##signal(velocity), GIVEN_##signal(applied), &seen)

/* Blocks that are asked something of signals. */
#define HASH_WAVE_OF(signal, wave, one, other) \
    do {                                       \
        HASH(signal, (wave).one);              \
        HASH(signal, (wave).other);            \
    } while (0)
#define WAVES(signal, ...)                                                                       \
    do {                                                                                         \
        lyapunov_wave_##signal wave;                                                             \
        lyapunov_##signal one, other;                                                            \
        BEGIN(wave_transform, signal, __VA_ARGS__);                                              \
        for (tick = 0; tick < ticks; ++tick) {                                                   \
            FILL(signal, one, random_most[1]);                                                   \
            FILL(signal, other, random_most[3]);                                                 \
            lyapunov_wave_transform_##signal##_encode(&storage, GIVEN_##signal(one), GIVEN_##signal(other), &wave); \
            HASH_WAVE_OF(signal, wave, there, back);                                             \
            lyapunov_wave_transform_##signal##_decode(&storage, GIVEN_##signal(one), GIVEN_##signal(other), &wave); \
            HASH_WAVE_OF(signal, wave, flow, effort);                                            \
            lyapunov_wave_transform_##signal##_effort(&storage, GIVEN_##signal(one), GIVEN_##signal(other), &wave); \
            HASH_WAVE_OF(signal, wave, effort, there);                                           \
            lyapunov_wave_transform_##signal##_flow(&storage, GIVEN_##signal(one), GIVEN_##signal(other), &wave); \
            HASH_WAVE_OF(signal, wave, flow, back);                                              \
        }                                                                                        \
        told("wave_transform_" #signal);                                                         \
    } while (0)
#define FILTERED(signal, ...)                                                                    \
    do {                                                                                         \
        lyapunov_##signal wave, sent;                                                            \
        BEGIN(wave_filter, signal, __VA_ARGS__);                                                 \
        for (tick = 0; tick < ticks; ++tick) {                                                   \
            FILL(signal, wave, random_most[3]);                                                  \
            lyapunov_wave_filter_##signal##_pass(&storage, GIVEN_##signal(wave), &sent);         \
            HASH(signal, sent);                                                                  \
        }                                                                                        \
        told("wave_filter_" #signal);                                                            \
    } while (0)
#define FOLLOWED(signal, ...)                                                                    \
    do {                                                                                         \
        lyapunov_wave_##signal wave;                                                             \
        lyapunov_##signal there, error, velocity;                                                \
        BEGIN(wave_follower, signal, __VA_ARGS__);                                               \
        for (tick = 0; tick < ticks; ++tick) {                                                   \
            FILL(signal, there, random_most[3]);                                                 \
            FILL(signal, error, random_most[0]);                                                 \
            FILL(signal, velocity, random_most[1]);                                              \
            lyapunov_wave_follower_##signal##_follow(&storage, GIVEN_##signal(there), GIVEN_##signal(error), GIVEN_##signal(velocity), &wave); \
            HASH_WAVE_OF(signal, wave, flow, effort);                                            \
            HASH(signal, wave.back);                                                             \
        }                                                                                        \
        told("wave_follower_" #signal);                                                          \
    } while (0)
#define DRAWN(signal, ...)                                                                       \
    do {                                                                                         \
        lyapunov_##signal wished, flow, passed;                                                  \
        number_##signal period, dissipated;                                                      \
        BEGIN(energy_tank, signal, __VA_ARGS__);                                                 \
        for (tick = 0; tick < ticks; ++tick) {                                                   \
            period = (number_##signal)random_period();                                           \
            dissipated = (number_##signal)random_number(0.5);                                    \
            FILL(signal, wished, random_most[3]);                                                \
            FILL(signal, flow, random_most[1]);                                                  \
            lyapunov_energy_tank_##signal##_pass(&storage, period, dissipated, GIVEN_##signal(wished), GIVEN_##signal(flow), &passed); \
            HASH(signal, passed);                                                                \
            hash_number((double)lyapunov_energy_tank_##signal##_energy(&storage));               \
        }                                                                                        \
        told("energy_tank_" #signal);                                                            \
    } while (0)
#define METERED(signal, ...)                                                                     \
    do {                                                                                         \
        lyapunov_sample_##signal sample;                                                         \
        lyapunov_correction_##signal correction;                                                 \
        lyapunov_##signal effort;                                                                \
        lyapunov_energy_summary_f64 sums;                                                        \
        static lyapunov_energy_meter_##signal meter;                                             \
        const lyapunov_energy_meter_##signal##_parameters none = { 0 };                          \
        BEGIN(lolc, signal, __VA_ARGS__);                                                        \
        checked(lyapunov_energy_meter_##signal##_init(&meter, &none), "energy_meter_" #signal);  \
        for (tick = 0; tick < ticks; ++tick) {                                                   \
            FILL_SAMPLE(signal, sample);                                                         \
            FILL(signal, effort, random_most[3]);                                                \
            lyapunov_lolc_##signal##_step(&storage, &sample, GIVEN_##signal(effort), &correction); \
            lyapunov_energy_meter_##signal##_add(&meter, &sample, &correction);                  \
        }                                                                                        \
        SUMMARY_##signal(signal, meter, sums);                                                   \
        hash_bits(sums.ticks);                                                                   \
        hash_number(sums.active);                                                                \
        hash_number(sums.rejected);                                                              \
        hash_number(sums.now);                                                                   \
        hash_number(sums.least);                                                                 \
        hash_number(sums.most);                                                                  \
        hash_number(sums.asked);                                                                \
        hash_number(sums.absorbed);                                                              \
        hash_number(sums.shortfall);                                                             \
        hash_number(sums.largest_shortfall);                                                     \
        told("energy_meter_" #signal);                                                           \
    } while (0)
#define SUMMARY_WIDE(signal, meter, sums) lyapunov_energy_meter_##signal##_summary(&meter, &sums)
#define SUMMARY_NARROW(signal, meter, sums)                                       \
    do {                                                                          \
        lyapunov_energy_summary_f32 narrow;                                       \
        lyapunov_energy_meter_##signal##_summary(&meter, &narrow);                \
        sums.ticks = narrow.ticks;                                                \
        sums.active = (double)narrow.active;                                      \
        sums.rejected = (double)narrow.rejected;                                  \
        sums.now = (double)narrow.now;                                            \
        sums.least = (double)narrow.least;                                        \
        sums.most = (double)narrow.most;                                          \
        sums.asked = (double)narrow.asked;                                        \
        sums.absorbed = (double)narrow.absorbed;                                  \
        sums.shortfall = (double)narrow.shortfall;                                \
        sums.largest_shortfall = (double)narrow.largest_shortfall;                \
    } while (0)
#define SUMMARY_f32 SUMMARY_NARROW
#define SUMMARY_f64 SUMMARY_WIDE
#define SUMMARY_f32x3 SUMMARY_NARROW
#define SUMMARY_f64x3 SUMMARY_WIDE
#define SUMMARY_f32x6 SUMMARY_NARROW
#define SUMMARY_f64x6 SUMMARY_WIDE
#define SUMMARY_f32screw SUMMARY_NARROW
#define SUMMARY_f64screw SUMMARY_WIDE

/* Poses at random, whose quaternions have any length. */
#define POSES(block, signal, pose_type, call, ...)                    \
    do {                                                             \
        lyapunov_checked_sample_##signal seen;                       \
        pose_type pose;                                              \
        lyapunov_##signal velocity, applied;                         \
        double now = 0.0;                                            \
        BEGIN(block, signal, __VA_ARGS__);                           \
        for (tick = 0; tick < ticks; ++tick) {                       \
            FILL(signal, pose.position, random_most[0]);             \
            FILL(signal, pose.quaternion, 1.0);                      \
            FILL(signal, velocity, random_most[1]);                  \
            FILL(signal, applied, random_most[3]);                   \
            now += random_period();                                  \
            (void)velocity, (void)now;                               \
            call(block, signal);                                     \
            HASH_READING(signal, seen);                              \
        }                                                            \
        told(#block "_" #signal);                                    \
    } while (0)
#define READ_POSE(block, signal) lyapunov_##block##_##signal##_read(&storage, &pose, &applied, &seen)
#define READ_MOVING_POSE(block, signal) lyapunov_##block##_##signal##_read_moving(&storage, &pose, &velocity, &applied, &seen)
#define READ_POSE_AT(block, signal) lyapunov_##block##_##signal##_read_at(&storage, now, &pose, &applied, &seen)
#define READ_MOVING_POSE_AT(block, signal) \
    lyapunov_##block##_##signal##_read_moving_at(&storage, now, &pose, &velocity, &applied, &seen)

/* A group on every signal. */
#define ON_EVERY(group, ...)          \
    do {                              \
        group(f32, __VA_ARGS__);      \
        group(f64, __VA_ARGS__);      \
        group(f32x3, __VA_ARGS__);    \
        group(f64x3, __VA_ARGS__);    \
        group(f32x6, __VA_ARGS__);    \
        group(f64x6, __VA_ARGS__);    \
        group(f32screw, __VA_ARGS__); \
        group(f64screw, __VA_ARGS__); \
    } while (0)

#endif
