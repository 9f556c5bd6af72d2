/* Every block over random ticks: prints a hash of all that came out, to be compared with the library in Rust. */
#include <stdio.h>
#include <stdlib.h>

#include <lyapunov.h>

#include "random.h"

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
        for (at_ = 0; at_ < sizeof numbers / sizeof numbers[0]; ++at_) { \
            numbers[at_] = (number_##signal)random_number(most);     \
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
    checked(lyapunov_##block##_##signal##_init(&storage, &parameters), #block "_" #signal)

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
            (void)velocity;                                          \
            (void)now;                                               \
            call(block, signal);                                     \
            HASH_SAMPLE(signal, seen.sample);                        \
            hash_bits(seen.accepted + 2 * seen.jumped + 4 * seen.late + 8 * seen.timed); \
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

/* Work and the credit of a quadratic drag on the first number of the velocity, which stands at the same place in every
   sample: behind the period and the position. */
#define CANDIDATE(signal)                                            \
    static number_##signal candidate_##signal(void *context, const lyapunov_sample_##signal *sample) \
    {                                                                \
        number_##signal work, speed;                                 \
        number_##signal drag = (number_##signal) * (const double *)context; \
        memcpy(&work, &sample->work, sizeof work);                   \
        memcpy(&speed, &sample->velocity, sizeof speed);             \
        return work + drag * speed * speed * sample->period;         \
    }                                                                \
    static number_##signal energy_##signal(void *context, const lyapunov_sample_##signal *sample) \
    {                                                                \
        number_##signal place, speed;                                \
        number_##signal mass = (number_##signal) * (const double *)context; \
        memcpy(&place, &sample->position, sizeof place);             \
        memcpy(&speed, &sample->velocity, sizeof speed);             \
        return (number_##signal)50 * place * place + mass * speed * speed; \
    }

CANDIDATE(f32)
CANDIDATE(f64)
CANDIDATE(f32x3)
CANDIDATE(f64x3)
CANDIDATE(f32x6)
CANDIDATE(f64x6)
CANDIDATE(f32screw)
CANDIDATE(f64screw)

#define LINE(block, beside, ...)                     \
    do {                                             \
        STABILIZER(block, f32, beside, __VA_ARGS__); \
        STABILIZER(block, f64, beside, __VA_ARGS__); \
    } while (0)
#define SPACES(block, beside, ...)                     \
    do {                                               \
        STABILIZER(block, f32x3, beside, __VA_ARGS__); \
        STABILIZER(block, f64x3, beside, __VA_ARGS__); \
        STABILIZER(block, f32x6, beside, __VA_ARGS__); \
        STABILIZER(block, f64x6, beside, __VA_ARGS__); \
    } while (0)
#define BODIES(block, beside, ...)                        \
    do {                                                  \
        STABILIZER(block, f32screw, beside, __VA_ARGS__); \
        STABILIZER(block, f64screw, beside, __VA_ARGS__); \
    } while (0)
#define EVERY(block, beside, ...)           \
    do {                                    \
        LINE(block, beside, __VA_ARGS__);   \
        SPACES(block, beside, __VA_ARGS__); \
        BODIES(block, beside, __VA_ARGS__); \
    } while (0)
#define EACH(block, on, call, ...)              \
    do {                                        \
        on(block, f32, call, __VA_ARGS__);      \
        on(block, f64, call, __VA_ARGS__);      \
        on(block, f32x3, call, __VA_ARGS__);    \
        on(block, f64x3, call, __VA_ARGS__);    \
        on(block, f32x6, call, __VA_ARGS__);    \
        on(block, f64x6, call, __VA_ARGS__);    \
    } while (0)
#define CALLED_BY(block, function)                                  \
    do {                                                            \
        CALLED(block, f32, function##_f32, { 80, 0.001f });          \
        CALLED(block, f64, function##_f64, { 80, 0.001f });          \
        CALLED(block, f32x3, function##_f32x3, { 80, 0.001f });      \
        CALLED(block, f64x3, function##_f64x3, { 80, 0.001f });      \
        CALLED(block, f32x6, function##_f32x6, { 80, 0.001f });      \
        CALLED(block, f64x6, function##_f64x6, { 80, 0.001f });      \
        CALLED(block, f32screw, function##_f32screw, { 80, 0.001f }); \
        CALLED(block, f64screw, function##_f64screw, { 80, 0.001f }); \
    } while (0)

/* Limit, damping of the device, budget; exact in both numbers. */
#define LOLC { 80, 0.5f, 0.001f }

static void controllers(void)
{
    EVERY(popc, ALONE, { 80, 0.001f });
    EVERY(lolc, ALONE, LOLC);
    LINE(lolc_in_contact, ALONE, { 80, 2, 0, 0.001f });
    CALLED_BY(lolc_custom, candidate);
    CALLED_BY(lolc_storage, energy);
    EVERY(lolc_sampled, ALONE, { LOLC });
    EVERY(lolc_compensated, ALONE, { LOLC });
}

static void refined(void)
{
    EVERY(bounded_credit, ALONE, { LOLC, 0.002f });
    EVERY(windowed_credit, ALONE, { LOLC, 3 });
    LINE(contact_reset, ALONE, { LOLC, 0.001f });
    EVERY(velocity_threshold, ALONE, { LOLC, 0.25f });
    EVERY(spread, ALONE, { LOLC, 5 });
    EVERY(soft_start, ALONE, { LOLC, 5 });
    EVERY(rate_limit, ALONE, { LOLC, 2000 });
    LINE(axis_weights, ALONE, { LOLC, 0.5f });
    LINE(along_direction, ALONE, { LOLC, 2 });
    EVERY(plausible, ALONE, { LOLC, 0.4f, 9 });
    EVERY(watchdog, ALONE, { LOLC, 0.003f, 0.01f });
    EVERY(safeguarded, ALONE, { LOLC, 0.002f, 2000, 0.4f, 9, 0.003f, 0.01f });
    STABILIZER(axis_weights, f32x3, ALONE, { LOLC, { { 1, 0.5f, 0 } } });
    STABILIZER(axis_weights, f64x3, ALONE, { LOLC, { { 1, 0.5f, 0 } } });
    STABILIZER(axis_weights, f32x6, ALONE, { LOLC, { { 1, 0.5f, 0, 1, 0.25f, 1 } } });
    STABILIZER(axis_weights, f64x6, ALONE, { LOLC, { { 1, 0.5f, 0, 1, 0.25f, 1 } } });
    STABILIZER(axis_weights, f32screw, ALONE, { LOLC, { { 1, 0.5f, 0 }, { 1, 0.25f, 1 } } });
    STABILIZER(axis_weights, f64screw, ALONE, { LOLC, { { 1, 0.5f, 0 }, { 1, 0.25f, 1 } } });
    STABILIZER(along_direction, f32x3, ALONE, { LOLC, { { 1, 2, -1 } } });
    STABILIZER(along_direction, f64x3, ALONE, { LOLC, { { 1, 2, -1 } } });
    STABILIZER(along_direction, f32x6, ALONE, { LOLC, { { 1, 2, -1, 1, 0, 4 } } });
    STABILIZER(along_direction, f64x6, ALONE, { LOLC, { { 1, 2, -1, 1, 0, 4 } } });
    STABILIZER(along_direction, f32screw, ALONE, { LOLC, { { 1, 2, -1 }, { 1, 0, 4 } } });
    STABILIZER(along_direction, f64screw, ALONE, { LOLC, { { 1, 2, -1 }, { 1, 0, 4 } } });
    STABILIZER(per_axis, f32x3, ALONE, { { LOLC, LOLC, LOLC } });
    STABILIZER(per_axis, f64x3, ALONE, { { LOLC, LOLC, LOLC } });
    STABILIZER(per_axis, f32x6, ALONE, { { LOLC, LOLC, LOLC, LOLC, LOLC, LOLC } });
    STABILIZER(per_axis, f64x6, ALONE, { { LOLC, LOLC, LOLC, LOLC, LOLC, LOLC } });
    BODIES(per_part, ALONE, { LOLC, { 0.25f, 0.01f, 0 } });
    BODIES(part_limits, ALONE, { 80, 0.25f, 0.5f, 0.01f, 0.001f });
}

static void family(void)
{
    EVERY(force_bound, ALONE, { 0.5f });
    EVERY(force_bounding, ALONE, { 0.5f });
    EVERY(tank, ALONE, { 0.01f, 0.001f, 0.02f, 1, 0.5f });
    EVERY(energy_bounding, ALONE, { 0.5f, 0.001f, 2 });
    EVERY(least_norm, ALONE, { 80, 0.5f, 0.5f, 0.001f });
    EVERY(slope_bound, ALONE, { 1000, 0.5f });
    LINE(memory_based, ALONE, { 0, 0.01f, 1 });
    LINE(path_memory, ALONE, { 0, 0.01f });
    EVERY(two_port_side, SIDE, { 80 });
    EVERY(drift_compensated, SIDE, { 0.5f, 0.25f, 2 });
    EVERY(two_layer, LAYER, { 0.01f, 0.125f, 0.02f, 4 });
}

static void watching(void)
{
    OBSERVER(f32, { 0.5f });
    OBSERVER(f64, { 0.5f });
    OBSERVER(f32x3, { 0.5f });
    OBSERVER(f64x3, { 0.5f });
    OBSERVER(f32x6, { 0.5f });
    OBSERVER(f64x6, { 0.5f });
    OBSERVER(f32screw, { 0.5f });
    OBSERVER(f64screw, { 0.5f });
    EACH(readings, READINGS, READ, { 0.001f, 16 });
    EACH(readings_measured, READINGS, READ_MOVING, { 0.001f, 16 });
    EACH(readings_low_passed, READINGS, READ, { 0.001f, 16, 30 });
    EACH(readings_windowed, READINGS, READ, { 0.001f, 16, 8, 0.001f });
    EACH(readings_clocked, READINGS, READ_AT, { 0.001f, 16 });
    EACH(readings_measured_clocked, READINGS, READ_MOVING_AT, { 0.001f, 16 });
}

int main(int count, char **arguments)
{
    if (count > 1) {
        ticks = strtoul(arguments[1], NULL, 10);
    }
    controllers();
    refined();
    family();
    watching();
    return 0;
}
