/* What C hands over by mistake: every case ends with a status or a rejection, and nothing is touched that should not be. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <lyapunov.h>

static int failures = 0;

#define EXPECT(what)                                        \
    do {                                                    \
        if (!(what)) {                                      \
            printf("line %d: not %s\n", __LINE__, #what);   \
            ++failures;                                     \
        }                                                   \
    } while (0)

static const lyapunov_popc_f64_parameters usual = { 80.0, 0.0 };
static const lyapunov_sample_f64 gave = { 1e-3, 0.0, 0.1, 1e-4, -2.0, -2e-4 };

static void null_pointers(void)
{
    lyapunov_popc_f64 popc;
    lyapunov_correction_f64 out;
    lyapunov_popc_f64_memory memory;
    char text[200];

    EXPECT(lyapunov_popc_f64_init(NULL, &usual).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_init(&popc, NULL).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_init(&popc, &usual).code == LYAPUNOV_OK);
    EXPECT(lyapunov_popc_f64_step(NULL, &gave, 1.0, &out) == LYAPUNOV_NULL);
    EXPECT(out.code == LYAPUNOV_NULL && out.accepted == 0 && !(out.effort < 0.0) && !(out.effort > 0.0));
    EXPECT(lyapunov_popc_f64_step(&popc, NULL, 1.0, &out) == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_step(&popc, &gave, 1.0, NULL) == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_retune(&popc, NULL).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_retune(NULL, &usual).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_save(NULL, &memory) == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_save(&popc, NULL) == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_restore(&popc, NULL).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_restore(NULL, &memory).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_reset(NULL) == LYAPUNOV_NULL);
    EXPECT(lyapunov_popc_f64_grant(NULL, 1.0).code == LYAPUNOV_NULL);
    EXPECT(isnan(lyapunov_popc_f64_observed_energy(NULL)));
    EXPECT(lyapunov_damping_limit_f64_of_mass(0.5, 0.2, 1e-3, 0, NULL).code == LYAPUNOV_NULL);
    EXPECT(lyapunov_status_text(NULL, text, sizeof text) > 0);
}

static void null_signals_and_functions(void)
{
    lyapunov_lolc_custom_f64 lolc;
    const lyapunov_lolc_custom_f64_parameters custom = { 80.0, 0.0 };
    lyapunov_popc_f64x3 three;
    const lyapunov_popc_f64x3_parameters of_three = { 80.0, 0.0 };
    const lyapunov_sample_f64x3 still = { 1e-3, { { 0 } }, { { 0 } }, { { 0 } }, { { 0 } }, { { 0 } } };
    lyapunov_correction_f64 out;
    lyapunov_correction_f64x3 out3;
    lyapunov_readings_f64x3 readings;
    const lyapunov_readings_f64x3_parameters told = { 1e-3, 2.0 };
    lyapunov_checked_sample_f64x3 read;

    EXPECT(lyapunov_popc_f64x3_init(&three, &of_three).code == LYAPUNOV_OK);
    EXPECT(lyapunov_popc_f64x3_step(&three, &still, NULL, &out3) == LYAPUNOV_NULL);
    EXPECT(out3.accepted == 0);
    EXPECT(lyapunov_lolc_custom_f64_init(&lolc, &custom).code == LYAPUNOV_OK);
    EXPECT(lyapunov_lolc_custom_f64_step(&lolc, &gave, 1.0, NULL, NULL, &out) == LYAPUNOV_NULL);
    EXPECT(out.accepted == 0);
    EXPECT(lyapunov_readings_f64x3_init(&readings, &told).code == LYAPUNOV_OK);
    EXPECT(lyapunov_readings_f64x3_read(&readings, NULL, NULL, &read) == LYAPUNOV_NULL);
    EXPECT(read.accepted == 0 && isnan(read.sample.work.axis[0]));
}

static void null_poses_and_waves(void)
{
    lyapunov_readings_of_poses_f64screw readings;
    const lyapunov_readings_of_poses_f64screw_parameters told = { 1e-3, 2.0, 20.0 };
    const lyapunov_f64pose still = { { 0 }, { 0, 0, 0, 1 } };
    const lyapunov_f64screw none = { { 0 }, { 0 } };
    lyapunov_checked_sample_f64screw read;
    lyapunov_wave_transform_f64x3 transform;
    const lyapunov_wave_transform_f64x3_parameters wrong = { 0.0 }, usual_wave = { 2.0 };
    lyapunov_wave_filter_f64 filter;
    const lyapunov_wave_filter_f64_parameters share = { 0.5 };
    const lyapunov_f64x3 ones = { { 1, 1, 1 } };
    lyapunov_wave_f64x3 wave;
    double sent = 1.0;

    EXPECT(lyapunov_readings_of_poses_f64screw_init(&readings, &told).code == LYAPUNOV_OK);
    EXPECT(lyapunov_readings_of_poses_f64screw_read(&readings, NULL, &none, &read) == LYAPUNOV_NULL);
    EXPECT(read.accepted == 0 && isnan(read.sample.work.rotation[0]));
    EXPECT(lyapunov_readings_of_poses_f64screw_read(&readings, &still, NULL, &read) == LYAPUNOV_NULL);
    EXPECT(lyapunov_readings_of_poses_f64screw_read(&readings, &still, &none, NULL) == LYAPUNOV_NULL);
    EXPECT(lyapunov_readings_of_poses_f64screw_read(NULL, &still, &none, &read) == LYAPUNOV_NULL);
    EXPECT(lyapunov_readings_of_poses_f64screw_read(&readings, &still, &none, &read) == LYAPUNOV_OK && read.accepted == 1);
    EXPECT(lyapunov_wave_transform_f64x3_init(&transform, &wrong).code == LYAPUNOV_PARAMETER);
    EXPECT(lyapunov_wave_transform_f64x3_init(&transform, &usual_wave).code == LYAPUNOV_OK);
    memset(&wave, 0xff, sizeof wave);
    EXPECT(lyapunov_wave_transform_f64x3_encode(&transform, &ones, NULL, &wave) == LYAPUNOV_NULL);
    EXPECT(!(wave.effort.axis[0] < 0.0) && !(wave.effort.axis[0] > 0.0) && !isnan(wave.effort.axis[0]));
    EXPECT(lyapunov_wave_transform_f64x3_encode(&transform, &ones, &ones, NULL) == LYAPUNOV_NULL);
    memset(&filter, 0, sizeof filter);
    EXPECT(lyapunov_wave_filter_f64_pass(&filter, 1.0, &sent) == LYAPUNOV_NOT_INITIALISED && !(sent > 0.0));
    EXPECT(lyapunov_wave_filter_f64_init(&filter, &share).code == LYAPUNOV_OK);
    EXPECT(lyapunov_wave_filter_f64_pass(&filter, NAN, &sent) == LYAPUNOV_OK && !(sent > 0.0) && !isnan(sent));
}

static void matrices_that_are_no_inertia(void)
{
    static const double bad[3] = { 2.0, NAN, INFINITY };
    const lyapunov_inertia_limit_f64x3_parameters sound = {
        { 80.0, 0.0, 0.0 }, { { { 1, 0, 0 } }, { { 0.5, 1, 0 } }, { { 0, 0, 1 } } }, 0.5, 1e-3, 0
    };
    lyapunov_inertia_limit_f64x3 limit, before;
    lyapunov_inertia_metric_f64x3 metric;
    char text[200];
    size_t at;

    EXPECT(lyapunov_inertia_limit_f64x3_init(&limit, &sound).code == LYAPUNOV_OK);
    for (at = 0; at < 3; ++at) {
        lyapunov_inertia_limit_f64x3_parameters told = sound;
        lyapunov_inertia_metric_f64x3_parameters of_metric = { { 80.0, 0.0, 0.0 }, { { { 0 } }, { { 0 } }, { { 0 } } } };
        lyapunov_status status;

        told.inertia[1].axis[0] = bad[at];
        memcpy(of_metric.inertia, told.inertia, sizeof told.inertia);
        before = limit;
        status = lyapunov_inertia_limit_f64x3_retune(&limit, &told);
        EXPECT(status.code == LYAPUNOV_PARAMETER && memcmp(&limit, &before, sizeof limit) == 0);
        (void)lyapunov_status_text(&status, text, sizeof text);
        EXPECT(strncmp(text, "inertia's pivot is ", 19) == 0 && (at > 0 || strncmp(text + 19, "-3;", 3) == 0));
        EXPECT(lyapunov_inertia_metric_f64x3_init(&metric, &of_metric).code == LYAPUNOV_PARAMETER);
    }
}

static void never_initialised(void)
{
    static const unsigned char fills[4] = { 0x00, 0xff, 0xa5, 0x01 };
    lyapunov_popc_f64 popc, before;
    lyapunov_lolc_f64 lolc;
    const lyapunov_lolc_f64_parameters credited = { 80.0, 0.5, 0.0 };
    lyapunov_correction_f64 out;
    size_t at;

    for (at = 0; at < 4; ++at) {
        memset(&popc, fills[at], sizeof popc);
        before = popc;
        EXPECT(lyapunov_popc_f64_step(&popc, &gave, 1.0, &out) == LYAPUNOV_NOT_INITIALISED);
        EXPECT(out.accepted == 0 && !(out.effort < 0.0) && !(out.effort > 0.0));
        EXPECT(lyapunov_popc_f64_retune(&popc, &usual).code == LYAPUNOV_NOT_INITIALISED);
        EXPECT(memcmp(&popc, &before, sizeof popc) == 0);
    }
    /* Initialised as another block. */
    EXPECT(lyapunov_lolc_f64_init(&lolc, &credited).code == LYAPUNOV_OK);
    memcpy(&popc, &lolc, sizeof popc);
    EXPECT(lyapunov_popc_f64_step(&popc, &gave, 1.0, &out) == LYAPUNOV_NOT_INITIALISED);
}

static void bytes_gone_bad(void)
{
    lyapunov_slope_bound_f64 slope;
    const lyapunov_slope_bound_f64_parameters parameters = { 1000.0, 0.0 };
    lyapunov_popc_f64 popc;
    lyapunov_correction_f64 out;
    unsigned fill;

    /* The tag stands, the rest is anything: a status or a rejection, and no other behaviour. */
    for (fill = 0; fill < 256; ++fill) {
        EXPECT(lyapunov_slope_bound_f64_init(&slope, &parameters).code == LYAPUNOV_OK);
        memset(slope.kept, (int)fill, sizeof slope.kept);
        (void)lyapunov_slope_bound_f64_step(&slope, &gave, 1.0, &out);
        EXPECT(lyapunov_popc_f64_init(&popc, &usual).code == LYAPUNOV_OK);
        memset(popc.kept, (int)fill, sizeof popc.kept);
        (void)lyapunov_popc_f64_step(&popc, &gave, 1.0, &out);
    }
}

static void misaligned(void)
{
    double room[16] = { 0 };
    lyapunov_popc_f64 *popc = (lyapunov_popc_f64 *)(void *)((char *)room + 1);
    lyapunov_popc_f64 sound;
    lyapunov_correction_f64 out;

    EXPECT(lyapunov_popc_f64_init(popc, &usual).code == LYAPUNOV_MISALIGNED);
    EXPECT(lyapunov_popc_f64_step(popc, &gave, 1.0, &out) == LYAPUNOV_MISALIGNED);
    EXPECT(out.accepted == 0);
    EXPECT(lyapunov_popc_f64_init(&sound, &usual).code == LYAPUNOV_OK);
    EXPECT(lyapunov_popc_f64_step(&sound, (const lyapunov_sample_f64 *)(const void *)((char *)room + 4), 1.0, &out)
           == LYAPUNOV_MISALIGNED);
}

static void another_version(void)
{
    lyapunov_popc_f64 popc;
    char text[200];
    lyapunov_status status = lyapunov_popc_f64_init_abi(&popc, &usual, LYAPUNOV_ABI + 1u);

    EXPECT(status.code == LYAPUNOV_OTHER_ABI);
    (void)lyapunov_status_text(&status, text, sizeof text);
    EXPECT(strstr(text, "version") != NULL);
    EXPECT(lyapunov_abi() == LYAPUNOV_ABI);
}

static void not_numbers(void)
{
    static const double bad[3] = { NAN, INFINITY, -INFINITY };
    lyapunov_popc_f64 popc, before;
    lyapunov_correction_f64 out;
    size_t at, field;

    EXPECT(lyapunov_popc_f64_init(&popc, &usual).code == LYAPUNOV_OK);
    for (at = 0; at < 3; ++at) {
        for (field = 0; field < sizeof gave / sizeof(double); ++field) {
            lyapunov_sample_f64 sample = gave;
            double numbers[sizeof gave / sizeof(double)];

            memcpy(numbers, &sample, sizeof numbers);
            numbers[field] = bad[at];
            memcpy(&sample, numbers, sizeof numbers);
            EXPECT(lyapunov_popc_f64_step(&popc, &sample, 1.0, &out) == LYAPUNOV_OK);
            EXPECT(isfinite(out.effort) && isfinite(out.observed_energy));
        }
        before = popc;
        EXPECT(lyapunov_popc_f64_step(&popc, &gave, bad[at], &out) == LYAPUNOV_OK && out.accepted == 0);
        EXPECT(lyapunov_popc_f64_grant(&popc, bad[at]).code == LYAPUNOV_PARAMETER);
        EXPECT(lyapunov_popc_f64_owe(&popc, bad[at]).code == LYAPUNOV_PARAMETER);
        (void)before;
    }
}

static double gives_nan(void *context, const lyapunov_sample_f64 *sample)
{
    (void)context;
    (void)sample;
    return NAN;
}

static void function_that_gives_nan(void)
{
    lyapunov_lolc_custom_f64 lolc;
    const lyapunov_lolc_custom_f64_parameters custom = { 80.0, 1e-3 };
    lyapunov_correction_f64 out;

    EXPECT(lyapunov_lolc_custom_f64_init(&lolc, &custom).code == LYAPUNOV_OK);
    EXPECT(lyapunov_lolc_custom_f64_step(&lolc, &gave, 1.0, gives_nan, NULL, &out) == LYAPUNOV_OK);
    EXPECT(out.accepted == 0 && !(out.effort > 0.0) && out.observed_energy <= 1e-3 && out.observed_energy >= 1e-3);
}

static void refusals_tell(void)
{
    lyapunov_popc_f64 popc, before;
    lyapunov_popc_f64_parameters wrong = { -0.25, 0.0 };
    lyapunov_popc_f64_memory memory = { { 0 } };
    const double infinite = INFINITY;
    char text[200], shorter[8];
    lyapunov_status status = lyapunov_popc_f64_init(&popc, &wrong);

    EXPECT(status.code == LYAPUNOV_PARAMETER);
    EXPECT(lyapunov_status_text(&status, text, sizeof text) == strlen(text));
    EXPECT(strcmp(text, "damping_limit is -0.25; it must be at least 0 (infinity: no limit)") == 0);
    EXPECT(lyapunov_status_text(&status, shorter, sizeof shorter) == strlen(text));
    EXPECT(strcmp(shorter, "damping") == 0);
    EXPECT(lyapunov_status_text(&status, NULL, 100) == strlen(text));
    EXPECT(lyapunov_popc_f64_init(&popc, &usual).code == LYAPUNOV_OK);
    before = popc;
    EXPECT(lyapunov_popc_f64_retune(&popc, &wrong).code == LYAPUNOV_PARAMETER);
    memcpy(memory.word, &infinite, sizeof infinite);
    status = lyapunov_popc_f64_restore(&popc, &memory);
    EXPECT(status.code == LYAPUNOV_MEMORY && memcmp(&popc, &before, sizeof popc) == 0);
    (void)lyapunov_status_text(&status, text, sizeof text);
    EXPECT(strcmp(text, "the stored memory is refused: stored sum is inf; it must be finite") == 0);
}

static void changes_without_room(void)
{
    lyapunov_popc_f32 popc, before;
    const lyapunov_popc_f32_parameters parameters = { 80, 0 };
    char text[200];
    lyapunov_status status;

    EXPECT(lyapunov_popc_f32_init(&popc, &parameters).code == LYAPUNOV_OK);
    EXPECT(lyapunov_popc_f32_grant(&popc, 3e38f).code == LYAPUNOV_OK);
    before = popc;
    status = lyapunov_popc_f32_grant(&popc, 2.5e38f);
    (void)lyapunov_status_text(&status, text, sizeof text);
    EXPECT(strncmp(text, "energy is 2.5e+38; it must be such that ", 40) == 0);
    EXPECT(lyapunov_popc_f32_owe(&popc, 3e38f).code == LYAPUNOV_OK && lyapunov_popc_f32_owe(&popc, 3e38f).code == LYAPUNOV_OK);
    status = lyapunov_popc_f32_owe(&popc, 2.5e38f);
    (void)lyapunov_status_text(&status, text, sizeof text);
    EXPECT(strncmp(text, "debt is 2.5e+38; it must be such that ", 38) == 0);
    EXPECT(lyapunov_popc_f32_grant(&popc, 3e38f).code == LYAPUNOV_OK && lyapunov_popc_f32_grant(&popc, 3e38f).code == LYAPUNOV_OK);
    EXPECT(memcmp(&popc, &before, sizeof popc) == 0);
}

/* Numbers in texts are those of printf. */
static void numbers_in_texts(void)
{
    static const double sizes[10] = { 0.25, 1.5, 123456.0, 1234567.0, 1e-4, 1.25e-5, 9.999996e9, 3e-310, 7.125, DBL_MAX };
    size_t at;

    for (at = 0; at < 10; ++at) {
        lyapunov_popc_f64 popc;
        lyapunov_popc_f64_parameters wrong = { 0.0, 0.0 };
        char text[200], number[64], expected[200];
        lyapunov_status status;

        wrong.damping_limit = -sizes[at];
        status = lyapunov_popc_f64_init(&popc, &wrong);
        (void)lyapunov_status_text(&status, text, sizeof text);
        (void)snprintf(number, sizeof number, "%g", wrong.damping_limit);
        (void)snprintf(expected, sizeof expected, "damping_limit is %s; it must be at least 0 (infinity: no limit)", number);
        EXPECT(strcmp(text, expected) == 0);
        if (strcmp(text, expected) != 0) {
            printf("%s\n", text);
        }
    }
}

static void copies(void)
{
    lyapunov_safeguarded_f32screw a, b;
    const lyapunov_safeguarded_f32screw_parameters parameters = { { 80, 0.5f, 0 }, 1e-3f, 2000, 1, 10, 0.01f, 0.1f };
    lyapunov_safeguarded_f32screw_memory memory;
    lyapunov_sample_f32screw sample = { 1e-3f, { { 0 }, { 0 } }, { { 0.1f }, { 0 } }, { { 1e-4f }, { 0 } }, { { -2 }, { 0 } }, { { -2e-4f }, { 0 } } };
    const lyapunov_f32screw effort = { { 1, 0, 0 }, { 0, 0, 0 } };
    lyapunov_correction_f32screw one, other;
    int tick;

    memset(&a, 0x11, sizeof a);
    memset(&b, 0x22, sizeof b);
    EXPECT(lyapunov_safeguarded_f32screw_init(&a, &parameters).code == LYAPUNOV_OK);
    EXPECT(lyapunov_safeguarded_f32screw_init(&b, &parameters).code == LYAPUNOV_OK);
    EXPECT(memcmp(&a, &b, sizeof a) == 0);
    for (tick = 0; tick < 100; ++tick) {
        EXPECT(lyapunov_safeguarded_f32screw_step(&a, &sample, &effort, &one) == LYAPUNOV_OK);
        EXPECT(memcmp(&a, &b, sizeof a) != 0);
        b = a;
        EXPECT(lyapunov_safeguarded_f32screw_save(&a, &memory) == LYAPUNOV_OK);
        EXPECT(lyapunov_safeguarded_f32screw_init(&b, &parameters).code == LYAPUNOV_OK);
        EXPECT(lyapunov_safeguarded_f32screw_restore(&b, &memory).code == LYAPUNOV_OK);
        EXPECT(memcmp(&a, &b, sizeof a) == 0);
        EXPECT(lyapunov_safeguarded_f32screw_step(&b, &sample, &effort, &other) == LYAPUNOV_OK);
        EXPECT(lyapunov_safeguarded_f32screw_step(&a, &sample, &effort, &one) == LYAPUNOV_OK);
        EXPECT(memcmp(&one, &other, sizeof one) == 0 && memcmp(&a, &b, sizeof a) == 0);
        sample.velocity.translation[0] = -sample.velocity.translation[0];
        b = a;
        b.kept[0] ^= 1;
    }
}

static void summary(void)
{
    lyapunov_energy_meter_f32 meter;
    const lyapunov_energy_meter_f32_parameters none = { 0 };
    lyapunov_energy_summary_f32 told, again;
    const lyapunov_sample_f32 sample = { 1e-3f, 0, 0.5f, 1e-4f, -2, -0.25f };
    lyapunov_correction_f32 correction = { 1.5f, -0.25f, 16, 0.125f, 1, LYAPUNOV_OK };

    EXPECT(lyapunov_energy_meter_f32_init(&meter, &none).code == LYAPUNOV_OK);
    EXPECT(lyapunov_energy_meter_f32_add(&meter, &sample, &correction) == LYAPUNOV_OK);
    EXPECT(lyapunov_energy_meter_f32_add(&meter, &sample, &correction) == LYAPUNOV_OK);
    EXPECT(lyapunov_energy_meter_f32_summary(&meter, &told) == LYAPUNOV_OK);
    EXPECT(told.ticks == 2 && (int)told.active == 2 && (int)(8 * told.absorbed) == -4);
    /* Each of them is a number, and their sum is beyond the range. */
    correction.observed_energy = correction.shortfall = FLT_MAX;
    EXPECT(lyapunov_energy_meter_f32_add(&meter, &sample, &correction) == LYAPUNOV_OK);
    EXPECT(lyapunov_energy_meter_f32_summary(&meter, &told) == LYAPUNOV_OK);
    EXPECT(told.ticks == 3 && told.most >= FLT_MAX && told.largest_shortfall >= FLT_MAX);
    correction.shortfall = NAN;
    EXPECT(lyapunov_energy_meter_f32_add(&meter, &sample, &correction) == LYAPUNOV_OK);
    memset(&told, 0x00, sizeof told);
    memset(&again, 0xff, sizeof again);
    EXPECT(lyapunov_energy_meter_f32_summary(&meter, &told) == LYAPUNOV_OK && told.ticks == 3);
    EXPECT(lyapunov_energy_meter_f32_summary(&meter, &again) == LYAPUNOV_OK && memcmp(&told, &again, sizeof told) == 0);
}

int main(void)
{
    null_pointers();
    null_signals_and_functions();
    null_poses_and_waves();
    matrices_that_are_no_inertia();
    never_initialised();
    bytes_gone_bad();
    misaligned();
    another_version();
    not_numbers();
    function_that_gives_nan();
    refusals_tell();
    changes_without_room();
    numbers_in_texts();
    copies();
    summary();
    printf("%s\n", failures == 0 ? "hard inputs: status or rejection" : "hard inputs: FAILED");
    return failures == 0 ? 0 : 1;
}
