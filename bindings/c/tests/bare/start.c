/* Start of a program on a bare Cortex-M: the vectors, the floating-point unit, then the C library's own start. */
#include <stdint.h>

extern void _start(void) __attribute__((noreturn));
extern uint32_t stack_top;

static void reset(void) __attribute__((noreturn));
static void reset(void)
{
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20; /* CPACR: full access to the unit */
    __asm__ volatile("dsb\n isb");
#endif
    _start();
}

static void stop(void)
{
    for (;;) {
    }
}

typedef void (*vector)(void);

__attribute__((section(".vectors"), used)) static const vector vectors[16] = {
    (vector)(uintptr_t)&stack_top, reset, stop, stop, stop, stop, stop,
};
