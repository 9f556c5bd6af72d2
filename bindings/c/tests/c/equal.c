/* Every block over random ticks: prints a hash of all that came out, to be compared with the library in Rust. */
#include "ticks.h"

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
#define TURNED(block, call, ...)                                        \
    do {                                                                \
        POSES(block, f32screw, lyapunov_f32pose, call, __VA_ARGS__);    \
        POSES(block, f64screw, lyapunov_f64pose, call, __VA_ARGS__);    \
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

/* Inertias: of their upper triangles nothing is read. */
#define THREE { { { 0.5f, 9, 9 } }, { { 0.125f, 0.25f, 9 } }, { { -0.0625f, 0.03125f, 0.125f } } }
#define SIX                                                                                            \
    { { { 2, 9, 9, 9, 9, 9 } }, { { 0.5f, 1.5f, 9, 9, 9, 9 } }, { { 0.25f, -0.125f, 1, 9, 9, 9 } },     \
      { { 0, 0.125f, 0.25f, 0.5f, 9, 9 } }, { { 0.0625f, 0, 0, -0.0625f, 0.25f, 9 } },                  \
      { { 0, 0.03125f, 0, 0, 0.015625f, 0.125f } } }

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
    STABILIZER(inertia_metric, f32x3, ALONE, { LOLC, THREE });
    STABILIZER(inertia_metric, f64x3, ALONE, { LOLC, THREE });
    STABILIZER(inertia_metric, f32x6, ALONE, { LOLC, SIX });
    STABILIZER(inertia_metric, f64x6, ALONE, { LOLC, SIX });
    STABILIZER(inertia_limit, f32x3, ALONE, { LOLC, THREE, 0.5f, 0.001f, 1 });
    STABILIZER(inertia_limit, f64x3, ALONE, { LOLC, THREE, 0.5f, 0.001f, 1 });
    STABILIZER(inertia_limit, f32x6, ALONE, { LOLC, SIX, 0.5f, 0.001f, 1 });
    STABILIZER(inertia_limit, f64x6, ALONE, { LOLC, SIX, 0.5f, 0.001f, 1 });
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
    ON_EVERY(OBSERVER, { 0.5f });
    EACH(readings, READINGS, READ, { 0.001f, 16 });
    READINGS(readings, f32screw, READ, { 0.001f, 16 });
    READINGS(readings, f64screw, READ, { 0.001f, 16 });
    EACH(readings_measured, READINGS, READ_MOVING, { 0.001f, 16 });
    READINGS(readings_measured, f32screw, READ_MOVING, { 0.001f, 16 });
    READINGS(readings_measured, f64screw, READ_MOVING, { 0.001f, 16 });
    EACH(readings_low_passed, READINGS, READ, { 0.001f, 16, 30 });
    EACH(readings_windowed, READINGS, READ, { 0.001f, 16, 8, 0.001f });
    EACH(readings_clocked, READINGS, READ_AT, { 0.001f, 16 });
    EACH(readings_measured_clocked, READINGS, READ_MOVING_AT, { 0.001f, 16 });
    TURNED(readings_of_poses, READ_POSE, { 0.001f, 16, 2000 });
    TURNED(readings_of_poses_measured, READ_MOVING_POSE, { 0.001f, 16, 2000 });
    TURNED(readings_of_poses_low_passed, READ_POSE, { 0.001f, 16, 2000, 30 });
    TURNED(readings_of_poses_windowed, READ_POSE, { 0.001f, 16, 2000, 8, 0.001f });
    TURNED(readings_of_poses_clocked, READ_POSE_AT, { 0.001f, 16, 2000 });
    TURNED(readings_of_poses_measured_clocked, READ_MOVING_POSE_AT, { 0.001f, 16, 2000 });
}

static void asked(void)
{
    ON_EVERY(WAVES, { 2 });
    ON_EVERY(FILTERED, { 0.25f });
    ON_EVERY(FOLLOWED, { 2, 50, 1.5f });
    ON_EVERY(DRAWN, { 0.01f, 0.001f, 0.02f, 1 });
    ON_EVERY(METERED, LOLC);
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
    asked();
    return 0;
}
