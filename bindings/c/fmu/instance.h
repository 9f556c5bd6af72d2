/* One unit of an importer: the numbers, and whom to tell what is wrong. */
#ifndef INSTANCE_H
#define INSTANCE_H

#include <stddef.h>

#include "unit.h"

struct instance {
    struct unit unit;
    void (*tell)(struct instance *instance, const char *why);
    void *environment; /* the importer's */
    void (*logger)(void);
    char *name;
};

/* Each returns 1, or 0 after the importer was told why. */
int instance_done(struct instance *instance, int done, const char *why);
int instance_get(struct instance *instance, const unsigned *references, size_t count, int flag, double *values);
int instance_set(struct instance *instance, const unsigned *references, size_t count, const double *values);
int instance_save(struct instance *instance, void **state);
int instance_restore(struct instance *instance, const void *state);
int instance_serialize(struct instance *instance, const void *state, void *bytes, size_t size);
int instance_deserialize(struct instance *instance, const void *bytes, size_t size, void **state);

/* Null if the token is another unit's or there is no memory. */
struct instance *instance_new(const char *name, const char *token);
void instance_free(struct instance *instance);

#endif
