/* What both versions of FMI ask of an instance. */
#include "instance.h"

#include <stdlib.h>
#include <string.h>

int instance_done(struct instance *instance, int done, const char *why)
{
    if (!done && instance) {
        instance->tell(instance, why);
    }
    return done;
}

int instance_get(struct instance *instance, const unsigned *references, size_t count, int flag, double *values)
{
    char why[WHY];
    size_t at;

    for (at = 0; at < count; ++at) {
        if (!instance_done(instance, unit_get(&instance->unit, references[at], flag, &values[at], why), why)) {
            return 0;
        }
    }
    return 1;
}

int instance_set(struct instance *instance, const unsigned *references, size_t count, const double *values)
{
    char why[WHY];
    size_t at;

    for (at = 0; at < count; ++at) {
        if (!instance_done(instance, unit_set(&instance->unit, references[at], values[at], why), why)) {
            return 0;
        }
    }
    return 1;
}

int instance_save(struct instance *instance, void **state)
{
    if (!*state) {
        *state = malloc(sizeof instance->unit);
    }
    if (!instance_done(instance, *state != NULL, "there is no memory for a state")) {
        return 0;
    }
    memcpy(*state, &instance->unit, sizeof instance->unit);
    return 1;
}

int instance_restore(struct instance *instance, const void *state)
{
    if (!instance_done(instance, state != NULL, "the state is null; get one first")) {
        return 0;
    }
    memcpy(&instance->unit, state, sizeof instance->unit);
    return 1;
}

int instance_serialize(struct instance *instance, const void *state, void *bytes, size_t size)
{
    if (!instance_done(instance, state && size >= sizeof instance->unit, "the state is null, or there are too few bytes for it")) {
        return 0;
    }
    memcpy(bytes, state, sizeof instance->unit);
    return 1;
}

int instance_deserialize(struct instance *instance, const void *bytes, size_t size, void **state)
{
    if (!instance_done(instance, size == sizeof instance->unit, "these bytes are no state of this unit") ||
        !instance_save(instance, state)) {
        return 0;
    }
    memcpy(*state, bytes, size);
    return 1;
}

struct instance *instance_new(const char *name, const char *token)
{
    struct instance *instance;

    if (!token || strcmp(token, TOKEN) != 0) {
        return NULL;
    }
    instance = calloc(1, sizeof *instance);
    if (!instance) {
        return NULL;
    }
    instance->name = malloc(strlen(name ? name : "") + 1);
    if (!instance->name) {
        free(instance);
        return NULL;
    }
    strcpy(instance->name, name ? name : "");
    unit_reset(&instance->unit);
    return instance;
}

void instance_free(struct instance *instance)
{
    if (instance) {
        free(instance->name);
        free(instance);
    }
}
