/* Stabilizers for sampled control loops. Generated from the library's functions: do not edit.
 *
 * Efforts resist the motion: positive power, effort times velocity, flows into the environment. Units are SI, angles in
 * radians. Storage is yours: a struct on the stack, static, or in a pool of your own; init makes it a block. Functions
 * that are handed a null or misaligned pointer, or storage that init has not seen, do nothing and say so.
 * A pointer leads to a variable that nobody else touches meanwhile. See README.md beside this file.
 *
 * SPDX-License-Identifier: MIT OR Apache-2.0
 */
#ifndef LYAPUNOV_H
#define LYAPUNOV_H

#include <stddef.h>
#include <stdint.h>

/* Version of the binary interface; init refuses another one. */
#define LYAPUNOV_ABI 1u

#ifndef LYAPUNOV_API
#define LYAPUNOV_API extern
#endif

#if defined(__cplusplus)
#define LYAPUNOV_ASSERT(what, name) static_assert(what, #name)
#elif defined(__STDC_VERSION__) && __STDC_VERSION__ >= 201112L
#define LYAPUNOV_ASSERT(what, name) _Static_assert(what, #name)
#else
#define LYAPUNOV_ASSERT(what, name) typedef char name##_is_as_in_the_library[(what) ? 1 : -1]
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* What became of a call. */
typedef uint32_t lyapunov_code;
enum {
    LYAPUNOV_OK = 0, /* done */
    LYAPUNOV_NULL = 1, /* a pointer is null; give the address of a variable */
    LYAPUNOV_MISALIGNED = 2, /* a pointer is misaligned; give the address of a variable of its type */
    LYAPUNOV_NOT_INITIALISED = 3, /* the storage is not initialised as this block; call its init first */
    LYAPUNOV_OTHER_ABI = 4, /* the header and the library differ in version; take both from one release */
    LYAPUNOV_PARAMETER = 5, /* a parameter is refused */
    LYAPUNOV_MEMORY = 6 /* the stored memory is refused */
};

/* What became of a call that may be refused: the code, and the refused parameter. */
typedef struct lyapunov_status {
    /* The refused value. */
    double value;
    /* The number of the requirement, where it has one. */
    double bound;
    /* The parameter's name, not closed by a zero; null without one. */
    const char *parameter;
    /* The length of the name. */
    uint16_t length;
    /* The requirement, for lyapunov_status_text. */
    uint16_t requirement;
    /* The code: LYAPUNOV_OK or what was wrong. */
    lyapunov_code code;
} lyapunov_status;
LYAPUNOV_ASSERT(offsetof(lyapunov_status, value) == 0, lyapunov_status_value);
LYAPUNOV_ASSERT(offsetof(lyapunov_status, bound) == 8, lyapunov_status_bound);
LYAPUNOV_ASSERT(offsetof(lyapunov_status, parameter) == 16, lyapunov_status_parameter);
/* Writes what is wrong and what would be right, as far as `capacity` bytes reach, with a closing zero; returns
   the length of the whole text. */
LYAPUNOV_API size_t lyapunov_status_text(const lyapunov_status *status, char *text, size_t capacity);
/* The version of the library's binary interface, to be compared with LYAPUNOV_ABI. */
LYAPUNOV_API uint32_t lyapunov_abi(void);

/* Signals: several axes, and twists or wrenches along the world's axes */
typedef struct lyapunov_f32x3 {
    /* The axes. */
    float axis[3];
} lyapunov_f32x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_f32x3) == 12, lyapunov_f32x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_f32x3, axis) == 0, lyapunov_f32x3_axis);
typedef struct lyapunov_f32x6 {
    /* The axes. */
    float axis[6];
} lyapunov_f32x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_f32x6) == 24, lyapunov_f32x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_f32x6, axis) == 0, lyapunov_f32x6_axis);
typedef struct lyapunov_f32screw {
    /* The part of translation: m/s, m, N, or J. */
    float translation[3];
    /* The part of rotation: rad/s, rad, N.m, or J. */
    float rotation[3];
} lyapunov_f32screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_f32screw) == 24, lyapunov_f32screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_f32screw, translation) == 0, lyapunov_f32screw_translation);
LYAPUNOV_ASSERT(offsetof(lyapunov_f32screw, rotation) == 12, lyapunov_f32screw_rotation);
typedef struct lyapunov_f64x3 {
    /* The axes. */
    double axis[3];
} lyapunov_f64x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_f64x3) == 24, lyapunov_f64x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_f64x3, axis) == 0, lyapunov_f64x3_axis);
typedef struct lyapunov_f64x6 {
    /* The axes. */
    double axis[6];
} lyapunov_f64x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_f64x6) == 48, lyapunov_f64x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_f64x6, axis) == 0, lyapunov_f64x6_axis);
typedef struct lyapunov_f64screw {
    /* The part of translation: m/s, m, N, or J. */
    double translation[3];
    /* The part of rotation: rad/s, rad, N.m, or J. */
    double rotation[3];
} lyapunov_f64screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_f64screw) == 48, lyapunov_f64screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_f64screw, translation) == 0, lyapunov_f64screw_translation);
LYAPUNOV_ASSERT(offsetof(lyapunov_f64screw, rotation) == 24, lyapunov_f64screw_rotation);

/* Samples and corrections: what the other side of a port did since the last call, and what a stabilizer did to
   an effort */
typedef struct lyapunov_sample_f32 {
    /* Time since the last call, s: above 0 and finite. */
    float period;
    /* Position now, m. */
    float position;
    /* Velocity now, m/s. */
    float velocity;
    /* Displacement since the last call, m. */
    float displacement;
    /* The effort applied last, N: after saturation and delay. */
    float applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    float work;
} lyapunov_sample_f32;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f32) == 24, lyapunov_sample_f32_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32, period) == 0, lyapunov_sample_f32_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32, position) == 4, lyapunov_sample_f32_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32, velocity) == 8, lyapunov_sample_f32_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32, displacement) == 12, lyapunov_sample_f32_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32, applied) == 16, lyapunov_sample_f32_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32, work) == 20, lyapunov_sample_f32_work);
typedef struct lyapunov_correction_f32 {
    /* The effort to command, correction included, N. */
    float effort;
    /* The observed energy before this tick's correction, J. */
    float observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    float alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    float shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f32;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f32) == 24, lyapunov_correction_f32_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32, effort) == 0, lyapunov_correction_f32_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32, observed_energy) == 4, lyapunov_correction_f32_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32, alpha) == 8, lyapunov_correction_f32_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32, shortfall) == 12, lyapunov_correction_f32_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32, accepted) == 16, lyapunov_correction_f32_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32, code) == 20, lyapunov_correction_f32_code);
typedef struct lyapunov_sample_f64 {
    /* Time since the last call, s: above 0 and finite. */
    double period;
    /* Position now, m. */
    double position;
    /* Velocity now, m/s. */
    double velocity;
    /* Displacement since the last call, m. */
    double displacement;
    /* The effort applied last, N: after saturation and delay. */
    double applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    double work;
} lyapunov_sample_f64;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f64) == 48, lyapunov_sample_f64_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64, period) == 0, lyapunov_sample_f64_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64, position) == 8, lyapunov_sample_f64_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64, velocity) == 16, lyapunov_sample_f64_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64, displacement) == 24, lyapunov_sample_f64_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64, applied) == 32, lyapunov_sample_f64_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64, work) == 40, lyapunov_sample_f64_work);
typedef struct lyapunov_correction_f64 {
    /* The effort to command, correction included, N. */
    double effort;
    /* The observed energy before this tick's correction, J. */
    double observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    double alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    double shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f64;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f64) == 40, lyapunov_correction_f64_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64, effort) == 0, lyapunov_correction_f64_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64, observed_energy) == 8, lyapunov_correction_f64_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64, alpha) == 16, lyapunov_correction_f64_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64, shortfall) == 24, lyapunov_correction_f64_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64, accepted) == 32, lyapunov_correction_f64_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64, code) == 36, lyapunov_correction_f64_code);
typedef struct lyapunov_sample_f32x3 {
    /* Time since the last call, s: above 0 and finite. */
    float period;
    /* Position now, m. */
    lyapunov_f32x3 position;
    /* Velocity now, m/s. */
    lyapunov_f32x3 velocity;
    /* Displacement since the last call, m. */
    lyapunov_f32x3 displacement;
    /* The effort applied last, N: after saturation and delay. */
    lyapunov_f32x3 applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    lyapunov_f32x3 work;
} lyapunov_sample_f32x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f32x3) == 64, lyapunov_sample_f32x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x3, period) == 0, lyapunov_sample_f32x3_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x3, position) == 4, lyapunov_sample_f32x3_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x3, velocity) == 16, lyapunov_sample_f32x3_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x3, displacement) == 28, lyapunov_sample_f32x3_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x3, applied) == 40, lyapunov_sample_f32x3_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x3, work) == 52, lyapunov_sample_f32x3_work);
typedef struct lyapunov_correction_f32x3 {
    /* The effort to command, correction included, N. */
    lyapunov_f32x3 effort;
    /* The observed energy before this tick's correction, J. */
    float observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    float alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    float shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f32x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f32x3) == 32, lyapunov_correction_f32x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x3, effort) == 0, lyapunov_correction_f32x3_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x3, observed_energy) == 12, lyapunov_correction_f32x3_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x3, alpha) == 16, lyapunov_correction_f32x3_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x3, shortfall) == 20, lyapunov_correction_f32x3_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x3, accepted) == 24, lyapunov_correction_f32x3_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x3, code) == 28, lyapunov_correction_f32x3_code);
typedef struct lyapunov_sample_f64x3 {
    /* Time since the last call, s: above 0 and finite. */
    double period;
    /* Position now, m. */
    lyapunov_f64x3 position;
    /* Velocity now, m/s. */
    lyapunov_f64x3 velocity;
    /* Displacement since the last call, m. */
    lyapunov_f64x3 displacement;
    /* The effort applied last, N: after saturation and delay. */
    lyapunov_f64x3 applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    lyapunov_f64x3 work;
} lyapunov_sample_f64x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f64x3) == 128, lyapunov_sample_f64x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x3, period) == 0, lyapunov_sample_f64x3_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x3, position) == 8, lyapunov_sample_f64x3_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x3, velocity) == 32, lyapunov_sample_f64x3_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x3, displacement) == 56, lyapunov_sample_f64x3_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x3, applied) == 80, lyapunov_sample_f64x3_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x3, work) == 104, lyapunov_sample_f64x3_work);
typedef struct lyapunov_correction_f64x3 {
    /* The effort to command, correction included, N. */
    lyapunov_f64x3 effort;
    /* The observed energy before this tick's correction, J. */
    double observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    double alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    double shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f64x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f64x3) == 56, lyapunov_correction_f64x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x3, effort) == 0, lyapunov_correction_f64x3_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x3, observed_energy) == 24, lyapunov_correction_f64x3_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x3, alpha) == 32, lyapunov_correction_f64x3_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x3, shortfall) == 40, lyapunov_correction_f64x3_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x3, accepted) == 48, lyapunov_correction_f64x3_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x3, code) == 52, lyapunov_correction_f64x3_code);
typedef struct lyapunov_sample_f32x6 {
    /* Time since the last call, s: above 0 and finite. */
    float period;
    /* Position now, m. */
    lyapunov_f32x6 position;
    /* Velocity now, m/s. */
    lyapunov_f32x6 velocity;
    /* Displacement since the last call, m. */
    lyapunov_f32x6 displacement;
    /* The effort applied last, N: after saturation and delay. */
    lyapunov_f32x6 applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    lyapunov_f32x6 work;
} lyapunov_sample_f32x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f32x6) == 124, lyapunov_sample_f32x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x6, period) == 0, lyapunov_sample_f32x6_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x6, position) == 4, lyapunov_sample_f32x6_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x6, velocity) == 28, lyapunov_sample_f32x6_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x6, displacement) == 52, lyapunov_sample_f32x6_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x6, applied) == 76, lyapunov_sample_f32x6_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32x6, work) == 100, lyapunov_sample_f32x6_work);
typedef struct lyapunov_correction_f32x6 {
    /* The effort to command, correction included, N. */
    lyapunov_f32x6 effort;
    /* The observed energy before this tick's correction, J. */
    float observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    float alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    float shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f32x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f32x6) == 44, lyapunov_correction_f32x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x6, effort) == 0, lyapunov_correction_f32x6_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x6, observed_energy) == 24, lyapunov_correction_f32x6_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x6, alpha) == 28, lyapunov_correction_f32x6_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x6, shortfall) == 32, lyapunov_correction_f32x6_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x6, accepted) == 36, lyapunov_correction_f32x6_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32x6, code) == 40, lyapunov_correction_f32x6_code);
typedef struct lyapunov_sample_f64x6 {
    /* Time since the last call, s: above 0 and finite. */
    double period;
    /* Position now, m. */
    lyapunov_f64x6 position;
    /* Velocity now, m/s. */
    lyapunov_f64x6 velocity;
    /* Displacement since the last call, m. */
    lyapunov_f64x6 displacement;
    /* The effort applied last, N: after saturation and delay. */
    lyapunov_f64x6 applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    lyapunov_f64x6 work;
} lyapunov_sample_f64x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f64x6) == 248, lyapunov_sample_f64x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x6, period) == 0, lyapunov_sample_f64x6_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x6, position) == 8, lyapunov_sample_f64x6_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x6, velocity) == 56, lyapunov_sample_f64x6_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x6, displacement) == 104, lyapunov_sample_f64x6_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x6, applied) == 152, lyapunov_sample_f64x6_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64x6, work) == 200, lyapunov_sample_f64x6_work);
typedef struct lyapunov_correction_f64x6 {
    /* The effort to command, correction included, N. */
    lyapunov_f64x6 effort;
    /* The observed energy before this tick's correction, J. */
    double observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    double alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    double shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f64x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f64x6) == 80, lyapunov_correction_f64x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x6, effort) == 0, lyapunov_correction_f64x6_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x6, observed_energy) == 48, lyapunov_correction_f64x6_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x6, alpha) == 56, lyapunov_correction_f64x6_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x6, shortfall) == 64, lyapunov_correction_f64x6_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x6, accepted) == 72, lyapunov_correction_f64x6_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64x6, code) == 76, lyapunov_correction_f64x6_code);
typedef struct lyapunov_sample_f32screw {
    /* Time since the last call, s: above 0 and finite. */
    float period;
    /* Position now, m. */
    lyapunov_f32screw position;
    /* Velocity now, m/s. */
    lyapunov_f32screw velocity;
    /* Displacement since the last call, m. */
    lyapunov_f32screw displacement;
    /* The effort applied last, N: after saturation and delay. */
    lyapunov_f32screw applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    lyapunov_f32screw work;
} lyapunov_sample_f32screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f32screw) == 124, lyapunov_sample_f32screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32screw, period) == 0, lyapunov_sample_f32screw_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32screw, position) == 4, lyapunov_sample_f32screw_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32screw, velocity) == 28, lyapunov_sample_f32screw_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32screw, displacement) == 52, lyapunov_sample_f32screw_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32screw, applied) == 76, lyapunov_sample_f32screw_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f32screw, work) == 100, lyapunov_sample_f32screw_work);
typedef struct lyapunov_correction_f32screw {
    /* The effort to command, correction included, N. */
    lyapunov_f32screw effort;
    /* The observed energy before this tick's correction, J. */
    float observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    float alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    float shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f32screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f32screw) == 44, lyapunov_correction_f32screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32screw, effort) == 0, lyapunov_correction_f32screw_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32screw, observed_energy) == 24, lyapunov_correction_f32screw_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32screw, alpha) == 28, lyapunov_correction_f32screw_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32screw, shortfall) == 32, lyapunov_correction_f32screw_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32screw, accepted) == 36, lyapunov_correction_f32screw_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f32screw, code) == 40, lyapunov_correction_f32screw_code);
typedef struct lyapunov_sample_f64screw {
    /* Time since the last call, s: above 0 and finite. */
    double period;
    /* Position now, m. */
    lyapunov_f64screw position;
    /* Velocity now, m/s. */
    lyapunov_f64screw velocity;
    /* Displacement since the last call, m. */
    lyapunov_f64screw displacement;
    /* The effort applied last, N: after saturation and delay. */
    lyapunov_f64screw applied;
    /* Work of the applied efforts since the last call, on each axis, J: applied times displacement under one
       held effort. */
    lyapunov_f64screw work;
} lyapunov_sample_f64screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_sample_f64screw) == 248, lyapunov_sample_f64screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64screw, period) == 0, lyapunov_sample_f64screw_period);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64screw, position) == 8, lyapunov_sample_f64screw_position);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64screw, velocity) == 56, lyapunov_sample_f64screw_velocity);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64screw, displacement) == 104, lyapunov_sample_f64screw_displacement);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64screw, applied) == 152, lyapunov_sample_f64screw_applied);
LYAPUNOV_ASSERT(offsetof(lyapunov_sample_f64screw, work) == 200, lyapunov_sample_f64screw_work);
typedef struct lyapunov_correction_f64screw {
    /* The effort to command, correction included, N. */
    lyapunov_f64screw effort;
    /* The observed energy before this tick's correction, J. */
    double observed_energy;
    /* The damping injected on this tick, N.s/m; 0 from a block that corrects in another way. */
    double alpha;
    /* The part of the debt that this tick's correction cannot serve, J; it stays. */
    double shortfall;
    /* 1 if the sample was accepted; else 0, with a zero effort. */
    uint32_t accepted;
    /* What the call returned. */
    uint32_t code;
} lyapunov_correction_f64screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_correction_f64screw) == 80, lyapunov_correction_f64screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64screw, effort) == 0, lyapunov_correction_f64screw_effort);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64screw, observed_energy) == 48, lyapunov_correction_f64screw_observed_energy);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64screw, alpha) == 56, lyapunov_correction_f64screw_alpha);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64screw, shortfall) == 64, lyapunov_correction_f64screw_shortfall);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64screw, accepted) == 72, lyapunov_correction_f64screw_accepted);
LYAPUNOV_ASSERT(offsetof(lyapunov_correction_f64screw, code) == 76, lyapunov_correction_f64screw_code);
/* The limit cap * mass / period, N.s/m, for an effort that acts `late` ticks late: `mass` is the least that
   moves with the port, kg, and a cap of 0.5 is usual. */
LYAPUNOV_API lyapunov_status lyapunov_damping_limit_f32_of_mass(float cap, float mass, float period, uint32_t late, float *limit);
/* The limit of a mobility, cap / (stiffness * period), m/(N.s), where force comes in and motion goes out:
   `stiffness` is the largest that holds the device, N/m. */
LYAPUNOV_API lyapunov_status lyapunov_damping_limit_f32_of_stiffness(float cap, float stiffness, float period, uint32_t late, float *limit);
/* The limit cap * mass / period, N.s/m, for an effort that acts `late` ticks late: `mass` is the least that
   moves with the port, kg, and a cap of 0.5 is usual. */
LYAPUNOV_API lyapunov_status lyapunov_damping_limit_f64_of_mass(double cap, double mass, double period, uint32_t late, double *limit);
/* The limit of a mobility, cap / (stiffness * period), m/(N.s), where force comes in and motion goes out:
   `stiffness` is the largest that holds the device, N/m. */
LYAPUNOV_API lyapunov_status lyapunov_damping_limit_f64_of_stiffness(double cap, double stiffness, double period, uint32_t late, double *limit);

/* lyapunov_popc_f32: Passivity observer/controller (Popc): sums the energy that crosses the port, and takes a
   debt back by a damper. */
typedef struct lyapunov_popc_f32_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_popc_f32_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32_parameters) == 8, lyapunov_popc_f32_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32_parameters, damping_limit) == 0, lyapunov_popc_f32_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32_parameters, budget) == 4, lyapunov_popc_f32_parameters_budget);
typedef struct lyapunov_popc_f32 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[2];
} lyapunov_popc_f32;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32) == 12, lyapunov_popc_f32_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32, tag) == 0, lyapunov_popc_f32_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32, kept) == 4, lyapunov_popc_f32_kept);
typedef struct lyapunov_popc_f32_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_popc_f32_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32_memory) == 4, lyapunov_popc_f32_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32_memory, word) == 0, lyapunov_popc_f32_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32_init_abi(lyapunov_popc_f32 *storage, const lyapunov_popc_f32_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f32_init(storage, parameters) lyapunov_popc_f32_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32_retune(lyapunov_popc_f32 *storage, const lyapunov_popc_f32_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f32_save(const lyapunov_popc_f32 *storage, lyapunov_popc_f32_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32_restore(lyapunov_popc_f32 *storage, const lyapunov_popc_f32_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f32_step(lyapunov_popc_f32 *storage, const lyapunov_sample_f32 *sample, float effort, lyapunov_correction_f32 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_popc_f32_observed_energy(const lyapunov_popc_f32 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f32_reset(lyapunov_popc_f32 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32_grant(lyapunov_popc_f32 *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32_owe(lyapunov_popc_f32 *storage, float debt);

/* lyapunov_popc_f64: Passivity observer/controller (Popc): sums the energy that crosses the port, and takes a
   debt back by a damper. */
typedef struct lyapunov_popc_f64_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_popc_f64_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64_parameters) == 16, lyapunov_popc_f64_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64_parameters, damping_limit) == 0, lyapunov_popc_f64_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64_parameters, budget) == 8, lyapunov_popc_f64_parameters_budget);
typedef struct lyapunov_popc_f64 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[2];
} lyapunov_popc_f64;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64) == 24, lyapunov_popc_f64_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64, tag) == 0, lyapunov_popc_f64_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64, kept) == 8, lyapunov_popc_f64_kept);
typedef struct lyapunov_popc_f64_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_popc_f64_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64_memory) == 8, lyapunov_popc_f64_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64_memory, word) == 0, lyapunov_popc_f64_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64_init_abi(lyapunov_popc_f64 *storage, const lyapunov_popc_f64_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f64_init(storage, parameters) lyapunov_popc_f64_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64_retune(lyapunov_popc_f64 *storage, const lyapunov_popc_f64_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f64_save(const lyapunov_popc_f64 *storage, lyapunov_popc_f64_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64_restore(lyapunov_popc_f64 *storage, const lyapunov_popc_f64_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f64_step(lyapunov_popc_f64 *storage, const lyapunov_sample_f64 *sample, double effort, lyapunov_correction_f64 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_popc_f64_observed_energy(const lyapunov_popc_f64 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f64_reset(lyapunov_popc_f64 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64_grant(lyapunov_popc_f64 *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64_owe(lyapunov_popc_f64 *storage, double debt);

/* lyapunov_popc_f32x3: Passivity observer/controller (Popc): sums the energy that crosses the port, and takes
   a debt back by a damper. */
typedef struct lyapunov_popc_f32x3_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_popc_f32x3_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32x3_parameters) == 8, lyapunov_popc_f32x3_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x3_parameters, damping_limit) == 0, lyapunov_popc_f32x3_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x3_parameters, budget) == 4, lyapunov_popc_f32x3_parameters_budget);
typedef struct lyapunov_popc_f32x3 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[2];
} lyapunov_popc_f32x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32x3) == 12, lyapunov_popc_f32x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x3, tag) == 0, lyapunov_popc_f32x3_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x3, kept) == 4, lyapunov_popc_f32x3_kept);
typedef struct lyapunov_popc_f32x3_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_popc_f32x3_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32x3_memory) == 4, lyapunov_popc_f32x3_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x3_memory, word) == 0, lyapunov_popc_f32x3_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x3_init_abi(lyapunov_popc_f32x3 *storage, const lyapunov_popc_f32x3_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f32x3_init(storage, parameters) lyapunov_popc_f32x3_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x3_retune(lyapunov_popc_f32x3 *storage, const lyapunov_popc_f32x3_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f32x3_save(const lyapunov_popc_f32x3 *storage, lyapunov_popc_f32x3_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x3_restore(lyapunov_popc_f32x3 *storage, const lyapunov_popc_f32x3_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f32x3_step(lyapunov_popc_f32x3 *storage, const lyapunov_sample_f32x3 *sample, const lyapunov_f32x3 *effort, lyapunov_correction_f32x3 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_popc_f32x3_observed_energy(const lyapunov_popc_f32x3 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f32x3_reset(lyapunov_popc_f32x3 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x3_grant(lyapunov_popc_f32x3 *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x3_owe(lyapunov_popc_f32x3 *storage, float debt);

/* lyapunov_popc_f64x3: Passivity observer/controller (Popc): sums the energy that crosses the port, and takes
   a debt back by a damper. */
typedef struct lyapunov_popc_f64x3_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_popc_f64x3_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64x3_parameters) == 16, lyapunov_popc_f64x3_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x3_parameters, damping_limit) == 0, lyapunov_popc_f64x3_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x3_parameters, budget) == 8, lyapunov_popc_f64x3_parameters_budget);
typedef struct lyapunov_popc_f64x3 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[2];
} lyapunov_popc_f64x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64x3) == 24, lyapunov_popc_f64x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x3, tag) == 0, lyapunov_popc_f64x3_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x3, kept) == 8, lyapunov_popc_f64x3_kept);
typedef struct lyapunov_popc_f64x3_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_popc_f64x3_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64x3_memory) == 8, lyapunov_popc_f64x3_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x3_memory, word) == 0, lyapunov_popc_f64x3_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x3_init_abi(lyapunov_popc_f64x3 *storage, const lyapunov_popc_f64x3_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f64x3_init(storage, parameters) lyapunov_popc_f64x3_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x3_retune(lyapunov_popc_f64x3 *storage, const lyapunov_popc_f64x3_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f64x3_save(const lyapunov_popc_f64x3 *storage, lyapunov_popc_f64x3_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x3_restore(lyapunov_popc_f64x3 *storage, const lyapunov_popc_f64x3_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f64x3_step(lyapunov_popc_f64x3 *storage, const lyapunov_sample_f64x3 *sample, const lyapunov_f64x3 *effort, lyapunov_correction_f64x3 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_popc_f64x3_observed_energy(const lyapunov_popc_f64x3 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f64x3_reset(lyapunov_popc_f64x3 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x3_grant(lyapunov_popc_f64x3 *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x3_owe(lyapunov_popc_f64x3 *storage, double debt);

/* lyapunov_popc_f32x6: Passivity observer/controller (Popc): sums the energy that crosses the port, and takes
   a debt back by a damper. */
typedef struct lyapunov_popc_f32x6_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_popc_f32x6_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32x6_parameters) == 8, lyapunov_popc_f32x6_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x6_parameters, damping_limit) == 0, lyapunov_popc_f32x6_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x6_parameters, budget) == 4, lyapunov_popc_f32x6_parameters_budget);
typedef struct lyapunov_popc_f32x6 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[2];
} lyapunov_popc_f32x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32x6) == 12, lyapunov_popc_f32x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x6, tag) == 0, lyapunov_popc_f32x6_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x6, kept) == 4, lyapunov_popc_f32x6_kept);
typedef struct lyapunov_popc_f32x6_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_popc_f32x6_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32x6_memory) == 4, lyapunov_popc_f32x6_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32x6_memory, word) == 0, lyapunov_popc_f32x6_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x6_init_abi(lyapunov_popc_f32x6 *storage, const lyapunov_popc_f32x6_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f32x6_init(storage, parameters) lyapunov_popc_f32x6_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x6_retune(lyapunov_popc_f32x6 *storage, const lyapunov_popc_f32x6_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f32x6_save(const lyapunov_popc_f32x6 *storage, lyapunov_popc_f32x6_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x6_restore(lyapunov_popc_f32x6 *storage, const lyapunov_popc_f32x6_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f32x6_step(lyapunov_popc_f32x6 *storage, const lyapunov_sample_f32x6 *sample, const lyapunov_f32x6 *effort, lyapunov_correction_f32x6 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_popc_f32x6_observed_energy(const lyapunov_popc_f32x6 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f32x6_reset(lyapunov_popc_f32x6 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x6_grant(lyapunov_popc_f32x6 *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32x6_owe(lyapunov_popc_f32x6 *storage, float debt);

/* lyapunov_popc_f64x6: Passivity observer/controller (Popc): sums the energy that crosses the port, and takes
   a debt back by a damper. */
typedef struct lyapunov_popc_f64x6_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_popc_f64x6_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64x6_parameters) == 16, lyapunov_popc_f64x6_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x6_parameters, damping_limit) == 0, lyapunov_popc_f64x6_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x6_parameters, budget) == 8, lyapunov_popc_f64x6_parameters_budget);
typedef struct lyapunov_popc_f64x6 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[2];
} lyapunov_popc_f64x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64x6) == 24, lyapunov_popc_f64x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x6, tag) == 0, lyapunov_popc_f64x6_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x6, kept) == 8, lyapunov_popc_f64x6_kept);
typedef struct lyapunov_popc_f64x6_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_popc_f64x6_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64x6_memory) == 8, lyapunov_popc_f64x6_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64x6_memory, word) == 0, lyapunov_popc_f64x6_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x6_init_abi(lyapunov_popc_f64x6 *storage, const lyapunov_popc_f64x6_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f64x6_init(storage, parameters) lyapunov_popc_f64x6_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x6_retune(lyapunov_popc_f64x6 *storage, const lyapunov_popc_f64x6_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f64x6_save(const lyapunov_popc_f64x6 *storage, lyapunov_popc_f64x6_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x6_restore(lyapunov_popc_f64x6 *storage, const lyapunov_popc_f64x6_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f64x6_step(lyapunov_popc_f64x6 *storage, const lyapunov_sample_f64x6 *sample, const lyapunov_f64x6 *effort, lyapunov_correction_f64x6 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_popc_f64x6_observed_energy(const lyapunov_popc_f64x6 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f64x6_reset(lyapunov_popc_f64x6 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x6_grant(lyapunov_popc_f64x6 *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64x6_owe(lyapunov_popc_f64x6 *storage, double debt);

/* lyapunov_popc_f32screw: Passivity observer/controller (Popc): sums the energy that crosses the port, and
   takes a debt back by a damper. */
typedef struct lyapunov_popc_f32screw_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_popc_f32screw_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32screw_parameters) == 8, lyapunov_popc_f32screw_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32screw_parameters, damping_limit) == 0, lyapunov_popc_f32screw_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32screw_parameters, budget) == 4, lyapunov_popc_f32screw_parameters_budget);
typedef struct lyapunov_popc_f32screw {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[2];
} lyapunov_popc_f32screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32screw) == 12, lyapunov_popc_f32screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32screw, tag) == 0, lyapunov_popc_f32screw_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32screw, kept) == 4, lyapunov_popc_f32screw_kept);
typedef struct lyapunov_popc_f32screw_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_popc_f32screw_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f32screw_memory) == 4, lyapunov_popc_f32screw_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f32screw_memory, word) == 0, lyapunov_popc_f32screw_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32screw_init_abi(lyapunov_popc_f32screw *storage, const lyapunov_popc_f32screw_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f32screw_init(storage, parameters) lyapunov_popc_f32screw_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32screw_retune(lyapunov_popc_f32screw *storage, const lyapunov_popc_f32screw_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f32screw_save(const lyapunov_popc_f32screw *storage, lyapunov_popc_f32screw_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32screw_restore(lyapunov_popc_f32screw *storage, const lyapunov_popc_f32screw_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f32screw_step(lyapunov_popc_f32screw *storage, const lyapunov_sample_f32screw *sample, const lyapunov_f32screw *effort, lyapunov_correction_f32screw *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_popc_f32screw_observed_energy(const lyapunov_popc_f32screw *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f32screw_reset(lyapunov_popc_f32screw *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32screw_grant(lyapunov_popc_f32screw *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f32screw_owe(lyapunov_popc_f32screw *storage, float debt);

/* lyapunov_popc_f64screw: Passivity observer/controller (Popc): sums the energy that crosses the port, and
   takes a debt back by a damper. */
typedef struct lyapunov_popc_f64screw_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_popc_f64screw_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64screw_parameters) == 16, lyapunov_popc_f64screw_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64screw_parameters, damping_limit) == 0, lyapunov_popc_f64screw_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64screw_parameters, budget) == 8, lyapunov_popc_f64screw_parameters_budget);
typedef struct lyapunov_popc_f64screw {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[2];
} lyapunov_popc_f64screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64screw) == 24, lyapunov_popc_f64screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64screw, tag) == 0, lyapunov_popc_f64screw_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64screw, kept) == 8, lyapunov_popc_f64screw_kept);
typedef struct lyapunov_popc_f64screw_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_popc_f64screw_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_popc_f64screw_memory) == 8, lyapunov_popc_f64screw_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_popc_f64screw_memory, word) == 0, lyapunov_popc_f64screw_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64screw_init_abi(lyapunov_popc_f64screw *storage, const lyapunov_popc_f64screw_parameters *parameters, uint32_t abi);
#define lyapunov_popc_f64screw_init(storage, parameters) lyapunov_popc_f64screw_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64screw_retune(lyapunov_popc_f64screw *storage, const lyapunov_popc_f64screw_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_popc_f64screw_save(const lyapunov_popc_f64screw *storage, lyapunov_popc_f64screw_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64screw_restore(lyapunov_popc_f64screw *storage, const lyapunov_popc_f64screw_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_popc_f64screw_step(lyapunov_popc_f64screw *storage, const lyapunov_sample_f64screw *sample, const lyapunov_f64screw *effort, lyapunov_correction_f64screw *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_popc_f64screw_observed_energy(const lyapunov_popc_f64screw *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_popc_f64screw_reset(lyapunov_popc_f64screw *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64screw_grant(lyapunov_popc_f64screw *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_popc_f64screw_owe(lyapunov_popc_f64screw *storage, double debt);

/* lyapunov_lolc_f32: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f32_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Damping that the device surely has, N.s/m. */
    float device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_lolc_f32_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32_parameters) == 12, lyapunov_lolc_f32_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32_parameters, damping_limit) == 0, lyapunov_lolc_f32_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32_parameters, device_damping) == 4, lyapunov_lolc_f32_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32_parameters, budget) == 8, lyapunov_lolc_f32_parameters_budget);
typedef struct lyapunov_lolc_f32 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[3];
} lyapunov_lolc_f32;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32) == 16, lyapunov_lolc_f32_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32, tag) == 0, lyapunov_lolc_f32_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32, kept) == 4, lyapunov_lolc_f32_kept);
typedef struct lyapunov_lolc_f32_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_lolc_f32_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32_memory) == 4, lyapunov_lolc_f32_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32_memory, word) == 0, lyapunov_lolc_f32_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32_init_abi(lyapunov_lolc_f32 *storage, const lyapunov_lolc_f32_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f32_init(storage, parameters) lyapunov_lolc_f32_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32_retune(lyapunov_lolc_f32 *storage, const lyapunov_lolc_f32_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32_save(const lyapunov_lolc_f32 *storage, lyapunov_lolc_f32_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32_restore(lyapunov_lolc_f32 *storage, const lyapunov_lolc_f32_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32_step(lyapunov_lolc_f32 *storage, const lyapunov_sample_f32 *sample, float effort, lyapunov_correction_f32 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_lolc_f32_observed_energy(const lyapunov_lolc_f32 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32_reset(lyapunov_lolc_f32 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32_grant(lyapunov_lolc_f32 *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32_owe(lyapunov_lolc_f32 *storage, float debt);

/* lyapunov_lolc_f64: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f64_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Damping that the device surely has, N.s/m. */
    double device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_lolc_f64_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64_parameters) == 24, lyapunov_lolc_f64_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64_parameters, damping_limit) == 0, lyapunov_lolc_f64_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64_parameters, device_damping) == 8, lyapunov_lolc_f64_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64_parameters, budget) == 16, lyapunov_lolc_f64_parameters_budget);
typedef struct lyapunov_lolc_f64 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[3];
} lyapunov_lolc_f64;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64) == 32, lyapunov_lolc_f64_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64, tag) == 0, lyapunov_lolc_f64_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64, kept) == 8, lyapunov_lolc_f64_kept);
typedef struct lyapunov_lolc_f64_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_lolc_f64_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64_memory) == 8, lyapunov_lolc_f64_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64_memory, word) == 0, lyapunov_lolc_f64_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64_init_abi(lyapunov_lolc_f64 *storage, const lyapunov_lolc_f64_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f64_init(storage, parameters) lyapunov_lolc_f64_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64_retune(lyapunov_lolc_f64 *storage, const lyapunov_lolc_f64_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64_save(const lyapunov_lolc_f64 *storage, lyapunov_lolc_f64_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64_restore(lyapunov_lolc_f64 *storage, const lyapunov_lolc_f64_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64_step(lyapunov_lolc_f64 *storage, const lyapunov_sample_f64 *sample, double effort, lyapunov_correction_f64 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_lolc_f64_observed_energy(const lyapunov_lolc_f64 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64_reset(lyapunov_lolc_f64 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64_grant(lyapunov_lolc_f64 *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64_owe(lyapunov_lolc_f64 *storage, double debt);

/* lyapunov_lolc_f32x3: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f32x3_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Damping that the device surely has, N.s/m. */
    float device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_lolc_f32x3_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32x3_parameters) == 12, lyapunov_lolc_f32x3_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x3_parameters, damping_limit) == 0, lyapunov_lolc_f32x3_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x3_parameters, device_damping) == 4, lyapunov_lolc_f32x3_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x3_parameters, budget) == 8, lyapunov_lolc_f32x3_parameters_budget);
typedef struct lyapunov_lolc_f32x3 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[3];
} lyapunov_lolc_f32x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32x3) == 16, lyapunov_lolc_f32x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x3, tag) == 0, lyapunov_lolc_f32x3_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x3, kept) == 4, lyapunov_lolc_f32x3_kept);
typedef struct lyapunov_lolc_f32x3_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_lolc_f32x3_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32x3_memory) == 4, lyapunov_lolc_f32x3_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x3_memory, word) == 0, lyapunov_lolc_f32x3_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x3_init_abi(lyapunov_lolc_f32x3 *storage, const lyapunov_lolc_f32x3_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f32x3_init(storage, parameters) lyapunov_lolc_f32x3_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x3_retune(lyapunov_lolc_f32x3 *storage, const lyapunov_lolc_f32x3_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32x3_save(const lyapunov_lolc_f32x3 *storage, lyapunov_lolc_f32x3_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x3_restore(lyapunov_lolc_f32x3 *storage, const lyapunov_lolc_f32x3_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32x3_step(lyapunov_lolc_f32x3 *storage, const lyapunov_sample_f32x3 *sample, const lyapunov_f32x3 *effort, lyapunov_correction_f32x3 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_lolc_f32x3_observed_energy(const lyapunov_lolc_f32x3 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32x3_reset(lyapunov_lolc_f32x3 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x3_grant(lyapunov_lolc_f32x3 *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x3_owe(lyapunov_lolc_f32x3 *storage, float debt);

/* lyapunov_lolc_f64x3: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f64x3_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Damping that the device surely has, N.s/m. */
    double device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_lolc_f64x3_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64x3_parameters) == 24, lyapunov_lolc_f64x3_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x3_parameters, damping_limit) == 0, lyapunov_lolc_f64x3_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x3_parameters, device_damping) == 8, lyapunov_lolc_f64x3_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x3_parameters, budget) == 16, lyapunov_lolc_f64x3_parameters_budget);
typedef struct lyapunov_lolc_f64x3 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[3];
} lyapunov_lolc_f64x3;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64x3) == 32, lyapunov_lolc_f64x3_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x3, tag) == 0, lyapunov_lolc_f64x3_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x3, kept) == 8, lyapunov_lolc_f64x3_kept);
typedef struct lyapunov_lolc_f64x3_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_lolc_f64x3_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64x3_memory) == 8, lyapunov_lolc_f64x3_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x3_memory, word) == 0, lyapunov_lolc_f64x3_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x3_init_abi(lyapunov_lolc_f64x3 *storage, const lyapunov_lolc_f64x3_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f64x3_init(storage, parameters) lyapunov_lolc_f64x3_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x3_retune(lyapunov_lolc_f64x3 *storage, const lyapunov_lolc_f64x3_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64x3_save(const lyapunov_lolc_f64x3 *storage, lyapunov_lolc_f64x3_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x3_restore(lyapunov_lolc_f64x3 *storage, const lyapunov_lolc_f64x3_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64x3_step(lyapunov_lolc_f64x3 *storage, const lyapunov_sample_f64x3 *sample, const lyapunov_f64x3 *effort, lyapunov_correction_f64x3 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_lolc_f64x3_observed_energy(const lyapunov_lolc_f64x3 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64x3_reset(lyapunov_lolc_f64x3 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x3_grant(lyapunov_lolc_f64x3 *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x3_owe(lyapunov_lolc_f64x3 *storage, double debt);

/* lyapunov_lolc_f32x6: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f32x6_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Damping that the device surely has, N.s/m. */
    float device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_lolc_f32x6_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32x6_parameters) == 12, lyapunov_lolc_f32x6_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x6_parameters, damping_limit) == 0, lyapunov_lolc_f32x6_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x6_parameters, device_damping) == 4, lyapunov_lolc_f32x6_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x6_parameters, budget) == 8, lyapunov_lolc_f32x6_parameters_budget);
typedef struct lyapunov_lolc_f32x6 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[3];
} lyapunov_lolc_f32x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32x6) == 16, lyapunov_lolc_f32x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x6, tag) == 0, lyapunov_lolc_f32x6_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x6, kept) == 4, lyapunov_lolc_f32x6_kept);
typedef struct lyapunov_lolc_f32x6_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_lolc_f32x6_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32x6_memory) == 4, lyapunov_lolc_f32x6_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32x6_memory, word) == 0, lyapunov_lolc_f32x6_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x6_init_abi(lyapunov_lolc_f32x6 *storage, const lyapunov_lolc_f32x6_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f32x6_init(storage, parameters) lyapunov_lolc_f32x6_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x6_retune(lyapunov_lolc_f32x6 *storage, const lyapunov_lolc_f32x6_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32x6_save(const lyapunov_lolc_f32x6 *storage, lyapunov_lolc_f32x6_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x6_restore(lyapunov_lolc_f32x6 *storage, const lyapunov_lolc_f32x6_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32x6_step(lyapunov_lolc_f32x6 *storage, const lyapunov_sample_f32x6 *sample, const lyapunov_f32x6 *effort, lyapunov_correction_f32x6 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_lolc_f32x6_observed_energy(const lyapunov_lolc_f32x6 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32x6_reset(lyapunov_lolc_f32x6 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x6_grant(lyapunov_lolc_f32x6 *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32x6_owe(lyapunov_lolc_f32x6 *storage, float debt);

/* lyapunov_lolc_f64x6: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f64x6_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Damping that the device surely has, N.s/m. */
    double device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_lolc_f64x6_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64x6_parameters) == 24, lyapunov_lolc_f64x6_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x6_parameters, damping_limit) == 0, lyapunov_lolc_f64x6_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x6_parameters, device_damping) == 8, lyapunov_lolc_f64x6_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x6_parameters, budget) == 16, lyapunov_lolc_f64x6_parameters_budget);
typedef struct lyapunov_lolc_f64x6 {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[3];
} lyapunov_lolc_f64x6;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64x6) == 32, lyapunov_lolc_f64x6_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x6, tag) == 0, lyapunov_lolc_f64x6_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x6, kept) == 8, lyapunov_lolc_f64x6_kept);
typedef struct lyapunov_lolc_f64x6_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_lolc_f64x6_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64x6_memory) == 8, lyapunov_lolc_f64x6_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64x6_memory, word) == 0, lyapunov_lolc_f64x6_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x6_init_abi(lyapunov_lolc_f64x6 *storage, const lyapunov_lolc_f64x6_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f64x6_init(storage, parameters) lyapunov_lolc_f64x6_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x6_retune(lyapunov_lolc_f64x6 *storage, const lyapunov_lolc_f64x6_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64x6_save(const lyapunov_lolc_f64x6 *storage, lyapunov_lolc_f64x6_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x6_restore(lyapunov_lolc_f64x6 *storage, const lyapunov_lolc_f64x6_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64x6_step(lyapunov_lolc_f64x6 *storage, const lyapunov_sample_f64x6 *sample, const lyapunov_f64x6 *effort, lyapunov_correction_f64x6 *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_lolc_f64x6_observed_energy(const lyapunov_lolc_f64x6 *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64x6_reset(lyapunov_lolc_f64x6 *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x6_grant(lyapunov_lolc_f64x6 *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64x6_owe(lyapunov_lolc_f64x6 *storage, double debt);

/* lyapunov_lolc_f32screw: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f32screw_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    float damping_limit;
    /* Damping that the device surely has, N.s/m. */
    float device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    float budget;
} lyapunov_lolc_f32screw_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32screw_parameters) == 12, lyapunov_lolc_f32screw_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32screw_parameters, damping_limit) == 0, lyapunov_lolc_f32screw_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32screw_parameters, device_damping) == 4, lyapunov_lolc_f32screw_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32screw_parameters, budget) == 8, lyapunov_lolc_f32screw_parameters_budget);
typedef struct lyapunov_lolc_f32screw {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint32_t tag;
    /* The library's own. */
    uint32_t kept[3];
} lyapunov_lolc_f32screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32screw) == 16, lyapunov_lolc_f32screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32screw, tag) == 0, lyapunov_lolc_f32screw_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32screw, kept) == 4, lyapunov_lolc_f32screw_kept);
typedef struct lyapunov_lolc_f32screw_memory {
    /* The memory without the parameters, to be stored. */
    uint32_t word[1];
} lyapunov_lolc_f32screw_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f32screw_memory) == 4, lyapunov_lolc_f32screw_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f32screw_memory, word) == 0, lyapunov_lolc_f32screw_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32screw_init_abi(lyapunov_lolc_f32screw *storage, const lyapunov_lolc_f32screw_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f32screw_init(storage, parameters) lyapunov_lolc_f32screw_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32screw_retune(lyapunov_lolc_f32screw *storage, const lyapunov_lolc_f32screw_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32screw_save(const lyapunov_lolc_f32screw *storage, lyapunov_lolc_f32screw_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32screw_restore(lyapunov_lolc_f32screw *storage, const lyapunov_lolc_f32screw_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32screw_step(lyapunov_lolc_f32screw *storage, const lyapunov_sample_f32screw *sample, const lyapunov_f32screw *effort, lyapunov_correction_f32screw *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API float lyapunov_lolc_f32screw_observed_energy(const lyapunov_lolc_f32screw *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f32screw_reset(lyapunov_lolc_f32screw *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32screw_grant(lyapunov_lolc_f32screw *storage, float energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f32screw_owe(lyapunov_lolc_f32screw *storage, float debt);

/* lyapunov_lolc_f64screw: Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
typedef struct lyapunov_lolc_f64screw_parameters {
    /* Largest damping, N.s/m, as `damping_limit_..._of_mass` gives it; 0 only observes. */
    double damping_limit;
    /* Damping that the device surely has, N.s/m. */
    double device_damping;
    /* Energy stored in the loop at the start, which may come back, J; usually 0. */
    double budget;
} lyapunov_lolc_f64screw_parameters;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64screw_parameters) == 24, lyapunov_lolc_f64screw_parameters_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64screw_parameters, damping_limit) == 0, lyapunov_lolc_f64screw_parameters_damping_limit);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64screw_parameters, device_damping) == 8, lyapunov_lolc_f64screw_parameters_device_damping);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64screw_parameters, budget) == 16, lyapunov_lolc_f64screw_parameters_budget);
typedef struct lyapunov_lolc_f64screw {
    /* Set by init. Storage is copied as any struct and compared by memcmp. */
    uint64_t tag;
    /* The library's own. */
    uint64_t kept[3];
} lyapunov_lolc_f64screw;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64screw) == 32, lyapunov_lolc_f64screw_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64screw, tag) == 0, lyapunov_lolc_f64screw_tag);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64screw, kept) == 8, lyapunov_lolc_f64screw_kept);
typedef struct lyapunov_lolc_f64screw_memory {
    /* The memory without the parameters, to be stored. */
    uint64_t word[1];
} lyapunov_lolc_f64screw_memory;
LYAPUNOV_ASSERT(sizeof(lyapunov_lolc_f64screw_memory) == 8, lyapunov_lolc_f64screw_memory_size);
LYAPUNOV_ASSERT(offsetof(lyapunov_lolc_f64screw_memory, word) == 0, lyapunov_lolc_f64screw_memory_word);
/* Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
   version of the header. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64screw_init_abi(lyapunov_lolc_f64screw *storage, const lyapunov_lolc_f64screw_parameters *parameters, uint32_t abi);
#define lyapunov_lolc_f64screw_init(storage, parameters) lyapunov_lolc_f64screw_init_abi((storage), (parameters), LYAPUNOV_ABI)
/* Changes the parameters between ticks; the memory stays. A refused change changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64screw_retune(lyapunov_lolc_f64screw *storage, const lyapunov_lolc_f64screw_parameters *parameters);
/* Takes the memory out, to be stored over a restart. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64screw_save(const lyapunov_lolc_f64screw *storage, lyapunov_lolc_f64screw_memory *memory);
/* Puts a stored memory in place of the own one. A refused one changes nothing. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64screw_restore(lyapunov_lolc_f64screw *storage, const lyapunov_lolc_f64screw_memory *memory);
/* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64screw_step(lyapunov_lolc_f64screw *storage, const lyapunov_sample_f64screw *sample, const lyapunov_f64screw *effort, lyapunov_correction_f64screw *correction);
/* The observed energy, J; NaN if the storage is not initialised. */
LYAPUNOV_API double lyapunov_lolc_f64screw_observed_energy(const lyapunov_lolc_f64screw *storage);
/* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
LYAPUNOV_API uint32_t lyapunov_lolc_f64screw_reset(lyapunov_lolc_f64screw *storage);
/* Adds as many joules of credit that were not absorbed. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64screw_grant(lyapunov_lolc_f64screw *storage, double energy);
/* Adds a debt of as many joules. */
LYAPUNOV_API lyapunov_status lyapunov_lolc_f64screw_owe(lyapunov_lolc_f64screw *storage, double debt);

#ifdef __cplusplus
}
#endif

#endif
