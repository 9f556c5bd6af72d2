// The wall of wall.c in C++: blocks are values, and a refused parameter tells what would be right.
#include <cstdio>

#include <lyapunov.hpp>

namespace {

constexpr double period = 1e-2;     // s
constexpr double mass = 0.3;        // kg
constexpr double stiffness = 50000; // N/m

struct Device {
    double position = -4e-3;
    double velocity = 0.0;

    void move(double force)
    {
        for (int part = 0; part < 100; ++part) {
            velocity += (-50.0 * position - 0.2 * velocity - force) / mass * (period / 100);
            position += velocity * (period / 100);
        }
    }
};

double late_swing(const lyapunov::Popc<double> &fresh, const lyapunov::Readings<double> &unread)
{
    auto popc = fresh; // copied as any value
    auto readings = unread;
    Device device;
    double applied = 0.0, swing = 0.0;
    for (int tick = 0; tick < 3000; ++tick) {
        const auto sample = readings.read(device.position, applied).sample;
        const double wall = sample.position > 0.0 ? stiffness * sample.position : 0.0;
        applied = popc.step(sample, wall).effort;
        device.move(applied);
        const double size = device.position < 0.0 ? -device.position : device.position;
        swing = tick >= 2000 && size > swing ? size : swing;
    }
    return swing;
}

} // namespace

int main()
{
    lyapunov::Readings<double> readings;
    lyapunov::Popc<double> popc;
    lyapunov::DampingLimit<double> limit;

    if (const auto refused = popc.init({-1.0, 0.0}); !refused) {
        std::printf("refused: %s\n", refused.text().data());
    }
    if (!limit.of_mass(0.5, mass, period) || !popc.init({limit.most, 0.0}) || !readings.init({period, 1e300})) {
        return 1;
    }
    const double swing = late_swing(popc, readings);
    std::printf("late swing with POPC  %10.4g m\n", swing);
    return swing < 4e-3 ? 0 : 1;
}
