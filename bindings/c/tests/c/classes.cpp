// What the classes take and answer. With REFUSED, one call that must not compile.
#ifdef WITH_EIGEN
#include <Eigen/Core>
#endif

#include <cmath>
#include <cstdio>

#include <lyapunov.hpp>

namespace {

using Three = lyapunov::Axes<double, 3>;
using Sample = lyapunov_sample_f32;

int failures = 0;

void expect(bool met, const char *what)
{
    if (!met) {
        std::printf("not %s\n", what);
        ++failures;
    }
}

// A vector as Eigen has them, here where Eigen is not: what a View looks at, and no more.
template <int Stride, bool IsVector = true> struct Numbers {
    using Scalar = double;
    enum { SizeAtCompileTime = 3, InnerStrideAtCompileTime = Stride, IsVectorAtCompileTime = IsVector };
    const double *data() const { return numbers; }
    const double *numbers;
};

bool is_one_two_three(lyapunov::View<double, 3> view)
{
    for (int at = 0; at < 3; ++at) {
        if (view[static_cast<std::size_t>(at)] < at + 1 || view[static_cast<std::size_t>(at)] > at + 1) {
            return false;
        }
    }
    return true;
}

const double numbers[9] = { 1, 2, 3, 4, 5, 6, 7, 8, 9 };

void views()
{
    const double array[3] = { 1, 2, 3 };
    const std::array<double, 3> standard{ { 1, 2, 3 } };
    const Three axes{ { 1, 2, 3 } };
    expect(is_one_two_three(array), "an array");
    expect(is_one_two_three(standard), "a std::array");
    expect(is_one_two_three(axes), "axes");
#ifdef __cpp_lib_span
    std::array<double, 3> own = standard;
    expect(is_one_two_three(std::span<const double, 3>(standard)), "a span");
    expect(is_one_two_three(std::span<double, 3>(own)), "a span of what may be written");
    expect(is_one_two_three(std::span<const double>(numbers).first<3>()), "the first three of a span");
    static_assert(!std::is_convertible<std::span<const double>, lyapunov::View<double, 3>>::value, "of any number");
#endif
    expect(is_one_two_three(Numbers<1>{ numbers }), "a vector");
#if REFUSED == 1
    expect(is_one_two_three(Numbers<2>{ numbers }), "a row");
#elif REFUSED == 2
    expect(is_one_two_three(Numbers<-1>{ numbers }), "a stride that is known later");
#elif REFUSED == 3
    expect(is_one_two_three(Numbers<1, false>{ numbers }), "a block of a matrix");
#endif
}

#ifdef WITH_EIGEN
void views_of_eigen()
{
    const Eigen::Map<const Eigen::Matrix3d> matrix(numbers);
    const Eigen::Matrix3d copied = matrix, turned = matrix.transpose();
    const Eigen::Vector3d vector = matrix.col(0), row = turned.row(0);
    Eigen::Matrix<double, 7, 1> long_vector;
    long_vector << 0, 1, 2, 3, 0, 0, 0;
    const Eigen::VectorXd dynamic = long_vector;
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> by_rows = turned;
    expect(is_one_two_three(vector), "Vector3d");
    expect(is_one_two_three(row), "a row, copied");
    expect(is_one_two_three(Eigen::RowVector3d(vector)), "RowVector3d");
    expect(is_one_two_three(copied.col(0)), "col()");
    expect(is_one_two_three(by_rows.row(0)), "row() of a matrix by rows");
    expect(is_one_two_three(vector.head<3>()), "head<3>()");
    expect(is_one_two_three(long_vector.segment<3>(1)), "segment<3>()");
    expect(is_one_two_three(dynamic.segment<3>(1)), "segment<3>() of a VectorXd");
    expect(is_one_two_three(Eigen::Map<const Eigen::Vector3d>(numbers)), "Map");
    expect(is_one_two_three(Eigen::Ref<const Eigen::Vector3d>(vector)), "Ref");
#if REFUSED == 4
    expect(is_one_two_three(turned.row(0)), "row()");
#elif REFUSED == 5
    expect(is_one_two_three(copied.diagonal()), "diagonal()");
#elif REFUSED == 6
    expect(is_one_two_three(Eigen::Map<const Eigen::Vector3d, 0, Eigen::InnerStride<2>>(numbers)), "InnerStride<2>");
#elif REFUSED == 7
    using Later = Eigen::InnerStride<>;
    expect(is_one_two_three(Eigen::Map<const Eigen::Vector3d, 0, Later>(numbers, Later(2))), "InnerStride<>");
#endif
}
#endif

float decrease(const Sample &sample) { return sample.work; }

struct Decrease {
    float operator()(const Sample &sample) const { return sample.work; }
};

void candidates()
{
    const Sample sample{ 1e-3f, 0, 0.1f, 1e-4f, -2, -2e-4f };
    float (*pointer)(const Sample &) = decrease;
    const Decrease functor{};
    int calls = 0;
    auto lambda = [&calls](const auto &seen) {
        ++calls;
        return seen.work;
    };
    const auto served = [&sample](auto &&candidate) {
        lyapunov::LolcCustom<float> lolc;
        expect(bool(lolc.init({ 100, 0 })), "initialised");
        const auto correction = lolc.step(sample, 0.5f, candidate);
        return correction.accepted == 1 && correction.observed_energy < 0;
    };
    lyapunov::LolcCustom<float> lolc;
    expect(bool(lolc.init({ 100, 0 })), "initialised");
    expect(lolc.step(sample, 0.5f, decrease).observed_energy < 0, "a function");
    expect(lolc.step(sample, 0.5f, &decrease).observed_energy < 0, "a function's address");
    expect(lolc.step(sample, 0.5f, Decrease{}).observed_energy < 0, "a functor for this call");
    expect(served(pointer), "a pointer to a function");
    expect(served(functor), "a functor that is const");
    expect(served(lambda) && calls == 1, "a lambda that counts");
}

void never_initialised()
{
    lyapunov::Popc<float> sound;
    const auto memory = lyapunov::Popc<float>{}.save();
    const auto summary = lyapunov::EnergyMeter<float>{}.summary();
    expect(bool(sound.init({ 100, 0 })), "initialised");
    const auto before = sound;
    expect(sound.restore(memory).code() == lyapunov::Code::Memory && sound == before, "a memory that restore refuses");
    expect(std::isnan(lyapunov::Observer<float>{}.observe({ 1e-3f, 0, 0.1f, 1e-4f, -2, -2e-4f })), "NaN of observe");
    expect(std::isnan(summary.least) && std::isnan(summary.absorbed) && summary.ticks == UINT64_MAX, "NaN of summary");
    const auto wave = lyapunov::WaveTransform<double>{}.encode(0.5, 3.0);
    const bool still = std::fabs(wave.flow) + std::fabs(wave.effort) + std::fabs(wave.there) + std::fabs(wave.back) <= 0.0;
    expect(still && std::fabs(lyapunov::EnergyTank<double>{}.pass(1e-3, 1.0, 1.0, -1.0)) <= 0.0, "0 of waves and of a tank");
    expect(std::isnan(sound.observed_energy()) == false, "a number of what is initialised");
}

// What has no memory is asked as it stands.
double reflected(const lyapunov::WaveTransform<double> &transform, const lyapunov::WaveFollower<double> &follower)
{
    const auto sent = transform.encode(0.5, 3.0);
    const auto told = transform.decode(sent.there, sent.back);
    const auto pushed = transform.effort(told.flow, sent.back), moved = transform.flow(told.effort, sent.there);
    return follower.follow(pushed.there, 0.0, 0.0).back + moved.back - sent.back;
}

void waves()
{
    lyapunov::WaveTransform<double> transform;
    lyapunov::WaveFollower<double> follower;
    expect(bool(transform.init({2.0})) && bool(follower.init({2.0, 0.0, 2.0})), "initialised");
    // A matched slave reflects nothing.
    expect(std::fabs(reflected(transform, follower)) < 1e-12, "the wave that came back");
#if REFUSED == 8
    transform.init({-2.0});
#endif
}

#if REFUSED == 9
lyapunov::Popc<lyapunov::Axes<float, 2>> on_two_axes;
#endif

// A block is its storage, whatever its verbs: as large, and copied byte by byte.
template <class Block> constexpr bool is_its_storage()
{
    return sizeof(Block) == sizeof(Block::storage) && std::is_standard_layout<Block>::value &&
           std::is_trivially_copyable<Block>::value && std::is_aggregate<Block>::value;
}
template <template <class> class Block> constexpr bool is_on_every_signal()
{
    return is_its_storage<Block<float>>() && is_its_storage<Block<double>>() &&
           is_its_storage<Block<lyapunov::Axes<float, 3>>>() && is_its_storage<Block<lyapunov::Axes<double, 6>>>() &&
           is_its_storage<Block<lyapunov::Screw<float>>>() && is_its_storage<Block<lyapunov::Screw<double>>>();
}
static_assert(is_on_every_signal<lyapunov::Popc>() && is_on_every_signal<lyapunov::LolcCustom>(), "of a stabilizer");
static_assert(is_on_every_signal<lyapunov::Readings>() && is_on_every_signal<lyapunov::EnergyMeter>(), "of an observer");
static_assert(is_on_every_signal<lyapunov::TwoLayer>() && is_on_every_signal<lyapunov::WaveFilter>(), "of a line");

// In a class that is derived from a block, names are those around it.
namespace derived {
using namespace lyapunov;
struct Block {
    int own;
};
struct Account {
    int own;
};
struct Mine : Popc<double> {
    Number<double> gain{};
    Block block{};
    Account account{};
};
static_assert(std::is_same<decltype(Mine::gain), double>::value, "a number");
static_assert(std::is_same<decltype(Mine::block), derived::Block>::value, "the block around it");
static_assert(std::is_same<decltype(Mine::account), derived::Account>::value, "the account around it");
} // namespace derived

} // namespace

int main()
{
    views();
#ifdef WITH_EIGEN
    views_of_eigen();
#endif
    candidates();
    waves();
    never_initialised();
    std::printf("%s\n", failures == 0 ? "classes: as they should" : "classes: FAILED");
    return failures == 0 ? 0 : 1;
}
