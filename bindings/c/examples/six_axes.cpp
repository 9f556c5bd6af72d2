// A six-axis device: twist and wrench with a damping limit for each part, and three axes with vectors of Eigen.
#include <cstdio>

#if __has_include(<Eigen/Core>)
#include <Eigen/Core>
#endif
#include <lyapunov.hpp>

namespace {

using Wrench = lyapunov::Screw<double>;
using Force = lyapunov::Axes<double, 3>;

bool whole_body()
{
    lyapunov::DampingLimit<double> translation, rotation;
    lyapunov::PartLimits<Wrench> lolc;
    // 0.4 kg and 2e-4 kg.m^2 at 1 kHz; no damping is credited.
    if (!translation.of_mass(0.5, 0.4, 1e-3) || !rotation.of_mass(0.5, 2e-4, 1e-3)
        || !lolc.init({translation.most, rotation.most, 0.0, 0.0, 0.0})) {
        return false;
    }
    lyapunov::HeldTick<Wrench> tick;
    tick.period = 1e-3;
    tick.velocity = {{0.1, 0.0, 0.0}, {0.0, 0.0, 3.0}};
    tick.displacement = {{1e-4, 0.0, 0.0}, {0.0, 0.0, 3e-3}};
    tick.applied = {{-2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}; // gave 0.2 mJ
    const auto correction = lolc.step(tick.sample(), Wrench{});
    std::printf("force %g N, torque %g N.m\n", correction.effort.translation[0], correction.effort.rotation[2]);
    return correction.accepted != 0 && correction.effort.translation[0] > 0.0 && correction.effort.rotation[2] > 0.0;
}

bool three_axes()
{
    lyapunov::Lolc<Force> lolc;
    if (!lolc.init({80.0, 0.5, 0.0})) {
        return false;
    }
    const auto sample = lyapunov::HeldTick<Force>{1e-3, {}, {{0.1, 0.0, 0.0}}, {{1e-4, 0.0, 0.0}}, {{-2.0, 0.0, 0.0}}}.sample();
#ifdef EIGEN_WORLD_VERSION
    const Eigen::Vector3d wall(0.5, 0.0, 1.0);
    const auto correction = lolc.step(sample, wall);
    const Eigen::Vector3d added = lyapunov::eigen(correction.effort) - wall;
    std::printf("added %g N along the motion\n", added.norm());
    return added.x() > 0.0 && added.z() == 0.0;
#else
    const double wall[3] = {0.5, 0.0, 1.0};
    const auto correction = lolc.step(sample, wall);
    return correction.effort.axis[0] > wall[0] && correction.effort.axis[2] == wall[2];
#endif
}

} // namespace

int main()
{
    return whole_body() && three_axes() ? 0 : 1;
}
