// Stabilizers for sampled control loops, for C++17. Generated: edit src/describe/frame.hpp, or the functions themselves.
//
// A header around lyapunov.h: value types, without exceptions, allocation or virtual functions. Names are those of the
// library in Rust. Signals are float, double, Axes<T, N> with N = 3 or 6, and Screw<T>; what takes several numbers takes a
// View of them: an array, std::array, a signal, or an Eigen vector whose numbers lie one after another, as those of a row or
// a diagonal do not: copy these into a vector. A method with a result has no code to tell: of a block that init has not seen,
// observe and summary give NaN (and the summary a count of all ones), save a memory that restore refuses, steps and readings what
// `accepted` 0 says, and waves and energy tanks 0: as a command that is no effort and no motion.
//
// SPDX-License-Identifier: MIT OR Apache-2.0
#ifndef LYAPUNOV_HPP
#define LYAPUNOV_HPP

// Each ends here: what follows would only be thousands of errors more.
#if !(__cplusplus >= 201703L || (defined(_MSVC_LANG) && _MSVC_LANG >= 201703L))
#error "lyapunov.hpp needs C++17: compile with -std=c++17, or /std:c++17"
#elif defined(Status)
#error "a macro Status, as <X11/Xlib.h> defines it, renames a class here: include lyapunov.hpp before it, or #undef Status"
#elif defined(read)
#error "a macro read, as <lwip/sockets.h> defines it, replaces a method here: include lyapunov.hpp before it, or #undef read"
#else

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>
#if __cplusplus > 201703L && __has_include(<span>)
#include <span>
#endif

#include "lyapunov.h"

namespace lyapunov {

namespace detail {

// None of those below. Its type keeps the refusal the only error.
template <class T, std::size_t N> struct axes_of {
    static_assert(N == 3 || N == 6, "signals have 1, 3 or 6 axes: one is float or double itself; for two take Axes<T, 3> and leave "
                                    "the third at 0, for four or five Axes<T, 6>");
    static_assert(std::is_same<T, float>::value || std::is_same<T, double>::value, "axes are of float or double");
    using type = T;
};
template <> struct axes_of<float, 3> { using type = lyapunov_f32x3; };
template <> struct axes_of<float, 6> { using type = lyapunov_f32x6; };
template <> struct axes_of<double, 3> { using type = lyapunov_f64x3; };
template <> struct axes_of<double, 6> { using type = lyapunov_f64x6; };
template <class T> struct screw_of;
template <> struct screw_of<float> { using type = lyapunov_f32screw; };
template <> struct screw_of<double> { using type = lyapunov_f64screw; };
template <class T> struct pose_of;
template <> struct pose_of<float> { using type = lyapunov_f32pose; };
template <> struct pose_of<double> { using type = lyapunov_f64pose; };

} // namespace detail

// Several axes.
template <class T, std::size_t N> using Axes = typename detail::axes_of<T, N>::type;

// Twist or wrench: translation, rotation.
template <class T> using Screw = typename detail::screw_of<T>::type;

// Position, and orientation as the quaternion x, y, z, w: the order of Eigen's coeffs().
template <class T> using Pose = typename detail::pose_of<T>::type;

// What became of a call.
enum class Code : lyapunov_code {
    Ok = LYAPUNOV_OK,
    Null = LYAPUNOV_NULL,
    Misaligned = LYAPUNOV_MISALIGNED,
    NotInitialised = LYAPUNOV_NOT_INITIALISED,
    OtherAbi = LYAPUNOV_OTHER_ABI,
    Parameter = LYAPUNOV_PARAMETER,
    Memory = LYAPUNOV_MEMORY
};

// What became of a call that may be refused; true if it was done.
class [[nodiscard]] Status {
public:
    explicit Status(const lyapunov_status &status) noexcept : status_(status) {}
    explicit operator bool() const noexcept { return status_.code == LYAPUNOV_OK; }
    Code code() const noexcept { return static_cast<Code>(status_.code); }
    // The parameter, its value and what would be right, closed by a zero.
    std::array<char, 192> text() const noexcept
    {
        std::array<char, 192> text{};
        lyapunov_status_text(&status_, text.data(), text.size());
        return text;
    }

private:
    lyapunov_status status_;
};

// N numbers that somebody else keeps.
template <class T, std::size_t N> class View {
public:
    View(const T (&numbers)[N]) noexcept : numbers_(numbers) {}
    View(const std::array<T, N> &numbers) noexcept : numbers_(numbers.data()) {}
#ifdef __cpp_lib_span
    // Of a fixed number: of another one it would not be known whether there are as many.
    template <class Same, class = std::enable_if_t<std::is_same<std::remove_const_t<Same>, T>::value>>
    View(std::span<Same, N> numbers) noexcept : numbers_(numbers.data()) {}
#endif
    View(const Axes<T, N> &axes) noexcept : numbers_(axes.axis) {}
    // A twist or wrench is three numbers of translation and three of rotation, one after another.
    template <std::size_t Six = N, class = std::enable_if_t<Six == 6>>
    View(const Screw<T> &screw) noexcept : numbers_(reinterpret_cast<const T *>(&screw)) {}
    // Whatever has its size and stride in its type as Eigen has them, and data() of its own: a vector, not an expression.
    template <class Vector, std::size_t Size = static_cast<std::size_t>(Vector::SizeAtCompileTime),
              class = decltype(std::declval<const Vector &>().data())>
    View(const Vector &vector) noexcept : numbers_(vector.data())
    {
        static_assert(Size == N, "a vector with as many numbers as the signal");
        static_assert(std::is_same<typename Vector::Scalar, T>::value, "a vector of the signal's number");
        static_assert(bool(Vector::IsVectorAtCompileTime), "a vector: the numbers of a matrix have no order");
        // From data() on N numbers are read: of a row or a diagonal they would be others than its own.
        static_assert(static_cast<int>(Vector::InnerStrideAtCompileTime) == 1,
                      "numbers one after another: copy a row, a diagonal or what has a stride into a vector first");
    }
    const T *data() const noexcept { return numbers_; }
    static constexpr std::size_t size() noexcept { return N; }
    const T *begin() const noexcept { return numbers_; }
    const T *end() const noexcept { return numbers_ + N; }
    const T &operator[](std::size_t at) const noexcept { return numbers_[at]; }

private:
    const T *numbers_;
};

namespace detail {

template <class Form, class T, std::size_t N> Form form(View<T, N> view) noexcept
{
    static_assert(sizeof(Form) == N * sizeof(T), "as many numbers");
    Form form;
    std::memcpy(&form, view.data(), sizeof form);
    return form;
}

// The candidate of a call: an object itself, which may remember, or a pointer to an ordinary function, which has no address
// that a context can be.
template <class Function>
using Candidate = std::conditional_t<std::is_function<std::remove_reference_t<Function>>::value, std::decay_t<Function>,
                                     std::remove_reference_t<Function> &>;

template <class Function> void *address(Function &function) noexcept
{
    return const_cast<void *>(static_cast<const void *>(std::addressof(function)));
}

// An exception does not cross C: one that leaves the candidate ends the program (std::terminate).
template <class Function, class T, class Sample> T call(void *function, const Sample *sample) noexcept
{
    return (*static_cast<Function *>(function))(*sample);
}

// What stays where a call that does nothing writes nothing: NaN in each number, and a memory that restore refuses.
template <class Answer> Answer unanswered() noexcept
{
    Answer answer;
    std::memset(&answer, 0xff, sizeof answer);
    return answer;
}

template <class Signal> struct of;
template <> struct of<float> { using Number = float; using Sample = lyapunov_sample_f32; };
template <> struct of<double> { using Number = double; using Sample = lyapunov_sample_f64; };
template <> struct of<lyapunov_f32x3> { using Number = float; using Sample = lyapunov_sample_f32x3; };
template <> struct of<lyapunov_f64x3> { using Number = double; using Sample = lyapunov_sample_f64x3; };
template <> struct of<lyapunov_f32x6> { using Number = float; using Sample = lyapunov_sample_f32x6; };
template <> struct of<lyapunov_f64x6> { using Number = double; using Sample = lyapunov_sample_f64x6; };
template <> struct of<lyapunov_f32screw> { using Number = float; using Sample = lyapunov_sample_f32screw; };
template <> struct of<lyapunov_f64screw> { using Number = double; using Sample = lyapunov_sample_f64screw; };

} // namespace detail

// A signal of the numbers in a view.
template <class Signal, class T, std::size_t N> Signal signal(View<T, N> view) noexcept
{
    return detail::form<Signal>(view);
}

template <class Signal> using Number = typename detail::of<Signal>::Number;

// What the other side of a port did since the last call.
template <class Signal> using PortSample = typename detail::of<Signal>::Sample;

// One period under one held effort, of which sample() makes a PortSample with its work.
template <class Signal> struct HeldTick {
    Number<Signal> period{};
    Signal position{};
    Signal velocity{};
    Signal displacement{};
    Signal applied{};

    PortSample<Signal> sample() const noexcept
    {
        constexpr std::size_t count = sizeof(Signal) / sizeof(Number<Signal>);
        std::array<Number<Signal>, count> moved{}, force{};
        std::memcpy(moved.data(), &displacement, sizeof displacement);
        std::memcpy(force.data(), &applied, sizeof applied);
        for (std::size_t at = 0; at < count; ++at) {
            force[at] *= moved[at];
        }
        PortSample<Signal> sample{period, position, velocity, displacement, applied, Signal{}};
        std::memcpy(&sample.work, force.data(), sizeof sample.work);
        return sample;
    }
};

// Largest damping that a stabilizer may inject, N.s/m.
template <class T> struct DampingLimit {
    T most{};

    // The limit cap * tan(pi / (4 (late + 1))) * mass / period, for an effort that acts `late` ticks late.
    Status of_mass(T cap, T mass, T period, std::uint32_t late = 0) noexcept
    {
        if constexpr (std::is_same<T, float>::value) {
            return Status(lyapunov_damping_limit_f32_of_mass(cap, mass, period, late, &most));
        } else {
            return Status(lyapunov_damping_limit_f64_of_mass(cap, mass, period, late, &most));
        }
    }

    // The limit of a mobility, cap * tan(pi / (4 (late + 1))) / (stiffness * period), m/(N.s).
    Status of_stiffness(T cap, T stiffness, T period, std::uint32_t late = 0) noexcept
    {
        if constexpr (std::is_same<T, float>::value) {
            return Status(lyapunov_damping_limit_f32_of_stiffness(cap, stiffness, period, late, &most));
        } else {
            return Status(lyapunov_damping_limit_f64_of_stiffness(cap, stiffness, period, late, &most));
        }
    }
};

namespace detail {

// The functions of C that every block has, by its storage. Called, not pointed to: the address of a function in a DLL is no constant.
template <class Storage> struct Calls;
#define LYAPUNOV_BLOCK(name)                                                                                                     \
    template <> struct detail::Calls<name> {                                                                                     \
        using Parameters = name##_parameters;                                                                                    \
        using Memory = name##_memory;                                                                                            \
        static auto init(name *storage, const Parameters *given) { return name##_init_abi(storage, given, LYAPUNOV_ABI); }       \
        static auto retune(name *storage, const Parameters *given) { return name##_retune(storage, given); }                     \
        static auto save(const name *storage, Memory *memory) { return name##_save(storage, memory); }                           \
        static auto restore(name *storage, const Memory *memory) { return name##_restore(storage, memory); }                     \
    };

// What every block has, beside verbs of its own. A class of the user's that is derived from a block finds names of its bases before those
// around it: hence long ones, and no alias.
template <class Storage> class LyapunovBlock {
public:
    using Parameters = typename Calls<Storage>::Parameters;
    using Memory = typename Calls<Storage>::Memory;
    /* Makes the block of parameters that fit together. */
    Status init(const Parameters &parameters) noexcept
    {
        static_assert(sizeof(LyapunovBlock) == sizeof(Storage) && std::is_standard_layout<LyapunovBlock>::value &&
                          std::is_trivially_copyable<LyapunovBlock>::value,
                      "a block is its storage");
        return Status(Calls<Storage>::init(&storage, &parameters));
    }
    /* Changes the parameters between ticks; the memory stays, so that a `budget` or `start` among them, which init alone reads,
       changes nothing. A refused change changes nothing. */
    Status retune(const Parameters &parameters) noexcept { return Status(Calls<Storage>::retune(&storage, &parameters)); }
    /* Takes the memory out, to be stored over a restart. */
    Memory save() const noexcept
    {
        auto memory = unanswered<Memory>();
        Calls<Storage>::save(&storage, &memory);
        return memory;
    }
    /* Puts a stored memory in place of the own one. A refused one changes nothing. */
    Status restore(const Memory &memory) noexcept { return Status(Calls<Storage>::restore(&storage, &memory)); }
    /* The same bytes: the same block in the same state. */
    friend bool operator==(const LyapunovBlock &a, const LyapunovBlock &b) noexcept
    {
        return std::memcmp(&a.storage, &b.storage, sizeof a.storage) == 0;
    }
    friend bool operator!=(const LyapunovBlock &a, const LyapunovBlock &b) noexcept { return !(a == b); }
    Storage storage{};
};

// The functions of C of an account, by the storage of its block.
template <class Storage> struct AccountCalls;
#define LYAPUNOV_ACCOUNT(name)                                                                                                   \
    LYAPUNOV_BLOCK(name)                                                                                                         \
    template <> struct detail::AccountCalls<name> {                                                                              \
        using Number = decltype(name##_observed_energy(nullptr));                                                                \
        static auto observed_energy(const name *storage) { return name##_observed_energy(storage); }                             \
        static auto reset(name *storage) { return name##_reset(storage); }                                                       \
        static auto grant(name *storage, Number energy) { return name##_grant(storage, energy); }                                \
        static auto owe(name *storage, Number debt) { return name##_owe(storage, debt); }                                        \
    };

// What a block with an account has, beside verbs of its own.
template <class Storage> class LyapunovAccount : public LyapunovBlock<Storage> {
public:
    /* The observed energy, J; NaN if the storage is not initialised. */
    typename AccountCalls<Storage>::Number observed_energy() const noexcept
    {
        return AccountCalls<Storage>::observed_energy(&this->storage);
    }
    /* Sets the observed energy to 0: credit is forfeited, a debt forgiven. */
    Code reset() noexcept { return static_cast<Code>(AccountCalls<Storage>::reset(&this->storage)); }
    /* Adds as many joules of credit that were not absorbed. */
    Status grant(typename AccountCalls<Storage>::Number energy) noexcept
    {
        return Status(AccountCalls<Storage>::grant(&this->storage, energy));
    }
    /* Adds a debt of as many joules. */
    Status owe(typename AccountCalls<Storage>::Number debt) noexcept
    {
        return Status(AccountCalls<Storage>::owe(&this->storage, debt));
    }
};

} // namespace detail

#ifdef EIGEN_WORLD_VERSION
// The axes as a vector of Eigen that reads the same memory; Eigen is included before this header.
template <class Form> auto eigen(const Form &axes) noexcept
{
    using T = Number<Form>;
    return Eigen::Map<const Eigen::Matrix<T, static_cast<int>(sizeof(Form) / sizeof(T)), 1>>(
        View<T, sizeof(Form) / sizeof(T)>(axes).data());
}
#endif

/* Readings at a fixed period (Readings::every), with velocities by differences: the memory of a port. The first reading displaces nothing, one that is NaN or jumps is rejected, the next spans the gap. */
template <class Signal> class Readings;

LYAPUNOV_BLOCK(lyapunov_readings_f32)
template <> class Readings<float> : public detail::LyapunovBlock<lyapunov_readings_f32> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32 read(float position, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_f32_read(&storage, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32 missed(float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_f32_missed(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f32_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f64)
template <> class Readings<double> : public detail::LyapunovBlock<lyapunov_readings_f64> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64 read(double position, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_f64_read(&storage, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64 missed(double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_f64_missed(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f64_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f32x3)
template <> class Readings<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_readings_f32x3> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x3 read(View<float, 3> position, View<float, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x3>(position); const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_f32x3_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x3 missed(View<float, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_f32x3_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f32x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f64x3)
template <> class Readings<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_readings_f64x3> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x3 read(View<double, 3> position, View<double, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x3>(position); const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_f64x3_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x3 missed(View<double, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_f64x3_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f64x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f32x6)
template <> class Readings<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_readings_f32x6> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x6 read(View<float, 6> position, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x6>(position); const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_f32x6_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x6 missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_f32x6_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f32x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f64x6)
template <> class Readings<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_readings_f64x6> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x6 read(View<double, 6> position, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x6>(position); const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_f64x6_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x6 missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_f64x6_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f64x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f32screw)
template <> class Readings<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_f32screw> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32screw read(View<float, 6> position, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32screw>(position); const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_f32screw_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32screw missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_f32screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_f64screw)
template <> class Readings<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_f64screw> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64screw read(View<double, 6> position, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64screw>(position); const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_f64screw_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64screw missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_f64screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_f64screw_restart(&storage)); }
};

/* Readings at a fixed period, with velocities that the device measures (Readings::measured). */
template <class Signal> class ReadingsMeasured;

LYAPUNOV_BLOCK(lyapunov_readings_measured_f32)
template <> class ReadingsMeasured<float> : public detail::LyapunovBlock<lyapunov_readings_measured_f32> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32 read_moving(float position, float velocity, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_measured_f32_read_moving(&storage, position, velocity, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32 missed_moving(float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_measured_f32_missed_moving(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f32_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f64)
template <> class ReadingsMeasured<double> : public detail::LyapunovBlock<lyapunov_readings_measured_f64> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64 read_moving(double position, double velocity, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_measured_f64_read_moving(&storage, position, velocity, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64 missed_moving(double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_measured_f64_missed_moving(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f64_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f32x3)
template <> class ReadingsMeasured<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_readings_measured_f32x3> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x3 read_moving(View<float, 3> position, View<float, 3> velocity, View<float, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x3>(position); const auto velocity_form = detail::form<lyapunov_f32x3>(velocity); const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_measured_f32x3_read_moving(&storage, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x3 missed_moving(View<float, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_measured_f32x3_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f32x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f64x3)
template <> class ReadingsMeasured<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_readings_measured_f64x3> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x3 read_moving(View<double, 3> position, View<double, 3> velocity, View<double, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x3>(position); const auto velocity_form = detail::form<lyapunov_f64x3>(velocity); const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_measured_f64x3_read_moving(&storage, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x3 missed_moving(View<double, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_measured_f64x3_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f64x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f32x6)
template <> class ReadingsMeasured<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_readings_measured_f32x6> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x6 read_moving(View<float, 6> position, View<float, 6> velocity, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x6>(position); const auto velocity_form = detail::form<lyapunov_f32x6>(velocity); const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_measured_f32x6_read_moving(&storage, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x6 missed_moving(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_measured_f32x6_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f32x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f64x6)
template <> class ReadingsMeasured<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_readings_measured_f64x6> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x6 read_moving(View<double, 6> position, View<double, 6> velocity, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x6>(position); const auto velocity_form = detail::form<lyapunov_f64x6>(velocity); const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_measured_f64x6_read_moving(&storage, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x6 missed_moving(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_measured_f64x6_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f64x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f32screw)
template <> class ReadingsMeasured<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_measured_f32screw> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32screw read_moving(View<float, 6> position, View<float, 6> velocity, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32screw>(position); const auto velocity_form = detail::form<lyapunov_f32screw>(velocity); const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_measured_f32screw_read_moving(&storage, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32screw missed_moving(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_measured_f32screw_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_f64screw)
template <> class ReadingsMeasured<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_measured_f64screw> {
public:
    /* The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64screw read_moving(View<double, 6> position, View<double, 6> velocity, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64screw>(position); const auto velocity_form = detail::form<lyapunov_f64screw>(velocity); const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_measured_f64screw_read_moving(&storage, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64screw missed_moving(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_measured_f64screw_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_f64screw_restart(&storage)); }
};

/* Readings at a fixed period, with velocities through a low pass (Readings::low_passed). */
template <class Signal> class ReadingsLowPassed;

LYAPUNOV_BLOCK(lyapunov_readings_low_passed_f32)
template <> class ReadingsLowPassed<float> : public detail::LyapunovBlock<lyapunov_readings_low_passed_f32> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32 read(float position, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_low_passed_f32_read(&storage, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32 missed(float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_low_passed_f32_missed(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_low_passed_f32_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_low_passed_f64)
template <> class ReadingsLowPassed<double> : public detail::LyapunovBlock<lyapunov_readings_low_passed_f64> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64 read(double position, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_low_passed_f64_read(&storage, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64 missed(double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_low_passed_f64_missed(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_low_passed_f64_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_low_passed_f32x3)
template <> class ReadingsLowPassed<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_readings_low_passed_f32x3> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x3 read(View<float, 3> position, View<float, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x3>(position); const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_low_passed_f32x3_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x3 missed(View<float, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_low_passed_f32x3_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_low_passed_f32x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_low_passed_f64x3)
template <> class ReadingsLowPassed<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_readings_low_passed_f64x3> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x3 read(View<double, 3> position, View<double, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x3>(position); const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_low_passed_f64x3_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x3 missed(View<double, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_low_passed_f64x3_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_low_passed_f64x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_low_passed_f32x6)
template <> class ReadingsLowPassed<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_readings_low_passed_f32x6> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x6 read(View<float, 6> position, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x6>(position); const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_low_passed_f32x6_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x6 missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_low_passed_f32x6_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_low_passed_f32x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_low_passed_f64x6)
template <> class ReadingsLowPassed<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_readings_low_passed_f64x6> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x6 read(View<double, 6> position, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x6>(position); const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_low_passed_f64x6_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x6 missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_low_passed_f64x6_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_low_passed_f64x6_restart(&storage)); }
};

/* Readings at a fixed period, with velocities over up to 16 readings (Readings::windowed). */
template <class Signal> class ReadingsWindowed;

LYAPUNOV_BLOCK(lyapunov_readings_windowed_f32)
template <> class ReadingsWindowed<float> : public detail::LyapunovBlock<lyapunov_readings_windowed_f32> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32 read(float position, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_windowed_f32_read(&storage, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32 missed(float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_windowed_f32_missed(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_windowed_f32_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_windowed_f64)
template <> class ReadingsWindowed<double> : public detail::LyapunovBlock<lyapunov_readings_windowed_f64> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64 read(double position, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_windowed_f64_read(&storage, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64 missed(double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_windowed_f64_missed(&storage, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_windowed_f64_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_windowed_f32x3)
template <> class ReadingsWindowed<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_readings_windowed_f32x3> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x3 read(View<float, 3> position, View<float, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x3>(position); const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_windowed_f32x3_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x3 missed(View<float, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_windowed_f32x3_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_windowed_f32x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_windowed_f64x3)
template <> class ReadingsWindowed<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_readings_windowed_f64x3> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x3 read(View<double, 3> position, View<double, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x3>(position); const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_windowed_f64x3_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x3 missed(View<double, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_windowed_f64x3_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_windowed_f64x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_windowed_f32x6)
template <> class ReadingsWindowed<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_readings_windowed_f32x6> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f32x6 read(View<float, 6> position, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x6>(position); const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_windowed_f32x6_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32x6 missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_windowed_f32x6_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_windowed_f32x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_windowed_f64x6)
template <> class ReadingsWindowed<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_readings_windowed_f64x6> {
public:
    /* The sample of this tick's reading: the position now, and the effort that the motor applied since the last. */
    lyapunov_checked_sample_f64x6 read(View<double, 6> position, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x6>(position); const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_windowed_f64x6_read(&storage, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64x6 missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_windowed_f64x6_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_windowed_f64x6_restart(&storage)); }
};

/* Readings at the times of a clock (Readings::clocked), with velocities by differences. */
template <class Signal> class ReadingsClocked;

LYAPUNOV_BLOCK(lyapunov_readings_clocked_f32)
template <> class ReadingsClocked<float> : public detail::LyapunovBlock<lyapunov_readings_clocked_f32> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32 read_at(double now, float position, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_clocked_f32_read_at(&storage, now, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32 missed_at(double now, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_clocked_f32_missed_at(&storage, now, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_clocked_f32_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_clocked_f64)
template <> class ReadingsClocked<double> : public detail::LyapunovBlock<lyapunov_readings_clocked_f64> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64 read_at(double now, double position, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_clocked_f64_read_at(&storage, now, position, applied, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64 missed_at(double now, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_clocked_f64_missed_at(&storage, now, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_clocked_f64_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_clocked_f32x3)
template <> class ReadingsClocked<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_readings_clocked_f32x3> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32x3 read_at(double now, View<float, 3> position, View<float, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x3>(position); const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_clocked_f32x3_read_at(&storage, now, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32x3 missed_at(double now, View<float, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_clocked_f32x3_missed_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_clocked_f32x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_clocked_f64x3)
template <> class ReadingsClocked<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_readings_clocked_f64x3> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64x3 read_at(double now, View<double, 3> position, View<double, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x3>(position); const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_clocked_f64x3_read_at(&storage, now, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64x3 missed_at(double now, View<double, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_clocked_f64x3_missed_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_clocked_f64x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_clocked_f32x6)
template <> class ReadingsClocked<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_readings_clocked_f32x6> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32x6 read_at(double now, View<float, 6> position, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x6>(position); const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_clocked_f32x6_read_at(&storage, now, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32x6 missed_at(double now, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_clocked_f32x6_missed_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_clocked_f32x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_clocked_f64x6)
template <> class ReadingsClocked<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_readings_clocked_f64x6> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64x6 read_at(double now, View<double, 6> position, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x6>(position); const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_clocked_f64x6_read_at(&storage, now, &position_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64x6 missed_at(double now, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_clocked_f64x6_missed_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_clocked_f64x6_restart(&storage)); }
};

/* Readings at the times of a clock, with velocities that the device measures. */
template <class Signal> class ReadingsMeasuredClocked;

LYAPUNOV_BLOCK(lyapunov_readings_measured_clocked_f32)
template <> class ReadingsMeasuredClocked<float> : public detail::LyapunovBlock<lyapunov_readings_measured_clocked_f32> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32 read_moving_at(double now, float position, float velocity, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_measured_clocked_f32_read_moving_at(&storage, now, position, velocity, applied, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32 missed_moving_at(double now, float applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f32>(); lyapunov_readings_measured_clocked_f32_missed_moving_at(&storage, now, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_clocked_f32_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_clocked_f64)
template <> class ReadingsMeasuredClocked<double> : public detail::LyapunovBlock<lyapunov_readings_measured_clocked_f64> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64 read_moving_at(double now, double position, double velocity, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_measured_clocked_f64_read_moving_at(&storage, now, position, velocity, applied, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64 missed_moving_at(double now, double applied) noexcept { auto checked = detail::unanswered<lyapunov_checked_sample_f64>(); lyapunov_readings_measured_clocked_f64_missed_moving_at(&storage, now, applied, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_clocked_f64_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_clocked_f32x3)
template <> class ReadingsMeasuredClocked<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_readings_measured_clocked_f32x3> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32x3 read_moving_at(double now, View<float, 3> position, View<float, 3> velocity, View<float, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x3>(position); const auto velocity_form = detail::form<lyapunov_f32x3>(velocity); const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_measured_clocked_f32x3_read_moving_at(&storage, now, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32x3 missed_moving_at(double now, View<float, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x3>(); lyapunov_readings_measured_clocked_f32x3_missed_moving_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_clocked_f32x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_clocked_f64x3)
template <> class ReadingsMeasuredClocked<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_readings_measured_clocked_f64x3> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64x3 read_moving_at(double now, View<double, 3> position, View<double, 3> velocity, View<double, 3> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x3>(position); const auto velocity_form = detail::form<lyapunov_f64x3>(velocity); const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_measured_clocked_f64x3_read_moving_at(&storage, now, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64x3 missed_moving_at(double now, View<double, 3> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x3>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x3>(); lyapunov_readings_measured_clocked_f64x3_missed_moving_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_clocked_f64x3_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_clocked_f32x6)
template <> class ReadingsMeasuredClocked<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_readings_measured_clocked_f32x6> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32x6 read_moving_at(double now, View<float, 6> position, View<float, 6> velocity, View<float, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f32x6>(position); const auto velocity_form = detail::form<lyapunov_f32x6>(velocity); const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_measured_clocked_f32x6_read_moving_at(&storage, now, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32x6 missed_moving_at(double now, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32x6>(); lyapunov_readings_measured_clocked_f32x6_missed_moving_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_clocked_f32x6_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_measured_clocked_f64x6)
template <> class ReadingsMeasuredClocked<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_readings_measured_clocked_f64x6> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64x6 read_moving_at(double now, View<double, 6> position, View<double, 6> velocity, View<double, 6> applied) noexcept { const auto position_form = detail::form<lyapunov_f64x6>(position); const auto velocity_form = detail::form<lyapunov_f64x6>(velocity); const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_measured_clocked_f64x6_read_moving_at(&storage, now, &position_form, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64x6 missed_moving_at(double now, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64x6>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64x6>(); lyapunov_readings_measured_clocked_f64x6_missed_moving_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_measured_clocked_f64x6_restart(&storage)); }
};

/* Readings of poses at a fixed period (Readings::of_poses), with twists by differences. The position of a sample is the sum of the displacements from one accepted pose to the next. A pose that is not finite, or whose quaternion is 0, is rejected. */
template <class Signal> class ReadingsOfPoses;

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_f32screw)
template <> class ReadingsOfPoses<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_f32screw> {
public:
    /* The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f32screw read(const lyapunov_f32pose &pose, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_f32screw_read(&storage, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32screw missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_f32screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_f64screw)
template <> class ReadingsOfPoses<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_f64screw> {
public:
    /* The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f64screw read(const lyapunov_f64pose &pose, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_f64screw_read(&storage, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64screw missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_f64screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_f64screw_restart(&storage)); }
};

/* Readings of poses at a fixed period, with twists that the device measures. */
template <class Signal> class ReadingsOfPosesMeasured;

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_measured_f32screw)
template <> class ReadingsOfPosesMeasured<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_measured_f32screw> {
public:
    /* The sample of this tick's reading: pose and twist now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f32screw read_moving(const lyapunov_f32pose &pose, View<float, 6> velocity, View<float, 6> applied) noexcept { const auto velocity_form = detail::form<lyapunov_f32screw>(velocity); const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_measured_f32screw_read_moving(&storage, &pose, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32screw missed_moving(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_measured_f32screw_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_measured_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_measured_f64screw)
template <> class ReadingsOfPosesMeasured<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_measured_f64screw> {
public:
    /* The sample of this tick's reading: pose and twist now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f64screw read_moving(const lyapunov_f64pose &pose, View<double, 6> velocity, View<double, 6> applied) noexcept { const auto velocity_form = detail::form<lyapunov_f64screw>(velocity); const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_measured_f64screw_read_moving(&storage, &pose, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64screw missed_moving(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_measured_f64screw_missed_moving(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_measured_f64screw_restart(&storage)); }
};

/* Readings of poses at a fixed period, with twists through a low pass. */
template <class Signal> class ReadingsOfPosesLowPassed;

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_low_passed_f32screw)
template <> class ReadingsOfPosesLowPassed<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_low_passed_f32screw> {
public:
    /* The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f32screw read(const lyapunov_f32pose &pose, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_low_passed_f32screw_read(&storage, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32screw missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_low_passed_f32screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_low_passed_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_low_passed_f64screw)
template <> class ReadingsOfPosesLowPassed<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_low_passed_f64screw> {
public:
    /* The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f64screw read(const lyapunov_f64pose &pose, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_low_passed_f64screw_read(&storage, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64screw missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_low_passed_f64screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_low_passed_f64screw_restart(&storage)); }
};

/* Readings of poses at a fixed period, with twists over up to 16 readings. */
template <class Signal> class ReadingsOfPosesWindowed;

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_windowed_f32screw)
template <> class ReadingsOfPosesWindowed<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_windowed_f32screw> {
public:
    /* The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f32screw read(const lyapunov_f32pose &pose, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_windowed_f32screw_read(&storage, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f32screw missed(View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_windowed_f32screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_windowed_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_windowed_f64screw)
template <> class ReadingsOfPosesWindowed<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_windowed_f64screw> {
public:
    /* The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last. */
    lyapunov_checked_sample_f64screw read(const lyapunov_f64pose &pose, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_windowed_f64screw_read(&storage, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading. */
    lyapunov_checked_sample_f64screw missed(View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_windowed_f64screw_missed(&storage, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_windowed_f64screw_restart(&storage)); }
};

/* Readings of poses at the times of a clock, with twists by differences. */
template <class Signal> class ReadingsOfPosesClocked;

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_clocked_f32screw)
template <> class ReadingsOfPosesClocked<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_clocked_f32screw> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32screw read_at(double now, const lyapunov_f32pose &pose, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_clocked_f32screw_read_at(&storage, now, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32screw missed_at(double now, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_clocked_f32screw_missed_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_clocked_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_clocked_f64screw)
template <> class ReadingsOfPosesClocked<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_clocked_f64screw> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64screw read_at(double now, const lyapunov_f64pose &pose, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_clocked_f64screw_read_at(&storage, now, &pose, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64screw missed_at(double now, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_clocked_f64screw_missed_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_clocked_f64screw_restart(&storage)); }
};

/* Readings of poses at the times of a clock, with twists that the device measures. */
template <class Signal> class ReadingsOfPosesMeasuredClocked;

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_measured_clocked_f32screw)
template <> class ReadingsOfPosesMeasuredClocked<Screw<float>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_measured_clocked_f32screw> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f32screw read_moving_at(double now, const lyapunov_f32pose &pose, View<float, 6> velocity, View<float, 6> applied) noexcept { const auto velocity_form = detail::form<lyapunov_f32screw>(velocity); const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_measured_clocked_f32screw_read_moving_at(&storage, now, &pose, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f32screw missed_moving_at(double now, View<float, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f32screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f32screw>(); lyapunov_readings_of_poses_measured_clocked_f32screw_missed_moving_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_measured_clocked_f32screw_restart(&storage)); }
};

LYAPUNOV_BLOCK(lyapunov_readings_of_poses_measured_clocked_f64screw)
template <> class ReadingsOfPosesMeasuredClocked<Screw<double>> : public detail::LyapunovBlock<lyapunov_readings_of_poses_measured_clocked_f64screw> {
public:
    /* The sample of the reading at the time `now`, s from any start. */
    lyapunov_checked_sample_f64screw read_moving_at(double now, const lyapunov_f64pose &pose, View<double, 6> velocity, View<double, 6> applied) noexcept { const auto velocity_form = detail::form<lyapunov_f64screw>(velocity); const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_measured_clocked_f64screw_read_moving_at(&storage, now, &pose, &velocity_form, &applied_form, &checked); return checked; }
    /* The sample of a tick without a reading at the time `now`, s. */
    lyapunov_checked_sample_f64screw missed_moving_at(double now, View<double, 6> applied) noexcept { const auto applied_form = detail::form<lyapunov_f64screw>(applied); auto checked = detail::unanswered<lyapunov_checked_sample_f64screw>(); lyapunov_readings_of_poses_measured_clocked_f64screw_missed_moving_at(&storage, now, &applied_form, &checked); return checked; }
    /* Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read. */
    Code restart() noexcept { return static_cast<Code>(lyapunov_readings_of_poses_measured_clocked_f64screw_restart(&storage)); }
};

/* Passivity observer/controller (Popc): sums the energy that crosses the port, and takes a debt back by a damper. In float the sum loses digits as credit grows, hundreds of joules in hours at 0.2 mJ a tick: for more than some minutes take lolc_compensated with a device_damping of 0, which is POPC in a sum that keeps them, or bounded_credit. */
template <class Signal> class Popc;

LYAPUNOV_ACCOUNT(lyapunov_popc_f32)
template <> class Popc<float> : public detail::LyapunovAccount<lyapunov_popc_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_popc_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f64)
template <> class Popc<double> : public detail::LyapunovAccount<lyapunov_popc_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_popc_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f32x3)
template <> class Popc<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_popc_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_popc_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f64x3)
template <> class Popc<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_popc_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_popc_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f32x6)
template <> class Popc<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_popc_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_popc_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f64x6)
template <> class Popc<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_popc_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_popc_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f32screw)
template <> class Popc<Screw<float>> : public detail::LyapunovAccount<lyapunov_popc_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_popc_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_popc_f64screw)
template <> class Popc<Screw<double>> : public detail::LyapunovAccount<lyapunov_popc_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_popc_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Lyapunov observer/controller (Lolc) that credits what the device's own damper burns. */
template <class Signal> class Lolc;

LYAPUNOV_ACCOUNT(lyapunov_lolc_f32)
template <> class Lolc<float> : public detail::LyapunovAccount<lyapunov_lolc_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_lolc_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f64)
template <> class Lolc<double> : public detail::LyapunovAccount<lyapunov_lolc_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_lolc_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f32x3)
template <> class Lolc<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_lolc_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_lolc_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f64x3)
template <> class Lolc<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_lolc_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_lolc_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f32x6)
template <> class Lolc<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_lolc_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_lolc_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f64x6)
template <> class Lolc<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_lolc_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_lolc_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f32screw)
template <> class Lolc<Screw<float>> : public detail::LyapunovAccount<lyapunov_lolc_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_lolc_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_f64screw)
template <> class Lolc<Screw<double>> : public detail::LyapunovAccount<lyapunov_lolc_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_lolc_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC whose candidate is a function of yours (Lolc with a LyapunovCandidate): it is handed to every step and gives the decrease over the sample, J, which is sample->work and what your candidate credits. Storage keeps neither function nor context. */
template <class Signal> class LolcCustom;

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f32)
template <> class LolcCustom<float> : public detail::LyapunovAccount<lyapunov_lolc_custom_f32> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort, Function &&function) noexcept { detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_lolc_custom_f32_step(&storage, &sample, effort, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f64)
template <> class LolcCustom<double> : public detail::LyapunovAccount<lyapunov_lolc_custom_f64> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort, Function &&function) noexcept { detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_lolc_custom_f64_step(&storage, &sample, effort, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f32x3)
template <> class LolcCustom<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_lolc_custom_f32x3> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_lolc_custom_f32x3_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32x3>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f64x3)
template <> class LolcCustom<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_lolc_custom_f64x3> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_lolc_custom_f64x3_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64x3>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f32x6)
template <> class LolcCustom<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_lolc_custom_f32x6> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_lolc_custom_f32x6_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32x6>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f64x6)
template <> class LolcCustom<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_lolc_custom_f64x6> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_lolc_custom_f64x6_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64x6>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f32screw)
template <> class LolcCustom<Screw<float>> : public detail::LyapunovAccount<lyapunov_lolc_custom_f32screw> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_lolc_custom_f32screw_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32screw>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_custom_f64screw)
template <> class LolcCustom<Screw<double>> : public detail::LyapunovAccount<lyapunov_lolc_custom_f64screw> {
public:
    /* One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch this storage. A value that is not finite rejects the sample. */
    template <class Function>
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_lolc_custom_f64screw_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64screw>, detail::address(candidate), &correction); return correction; }
};

/* LOLC whose candidate is a storage function of yours (Lolc with a StorageFunction): it is handed to every step and gives the energy V at the sample's position and velocity, J. */
template <class Signal> class LolcStorage;

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f32)
template <> class LolcStorage<float> : public detail::LyapunovAccount<lyapunov_lolc_storage_f32> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort, Function &&function) noexcept { detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_lolc_storage_f32_step(&storage, &sample, effort, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f64)
template <> class LolcStorage<double> : public detail::LyapunovAccount<lyapunov_lolc_storage_f64> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort, Function &&function) noexcept { detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_lolc_storage_f64_step(&storage, &sample, effort, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f32x3)
template <> class LolcStorage<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_lolc_storage_f32x3> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_lolc_storage_f32x3_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32x3>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f64x3)
template <> class LolcStorage<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_lolc_storage_f64x3> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_lolc_storage_f64x3_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64x3>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f32x6)
template <> class LolcStorage<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_lolc_storage_f32x6> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_lolc_storage_f32x6_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32x6>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f64x6)
template <> class LolcStorage<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_lolc_storage_f64x6> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_lolc_storage_f64x6_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64x6>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f32screw)
template <> class LolcStorage<Screw<float>> : public detail::LyapunovAccount<lyapunov_lolc_storage_f32screw> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_lolc_storage_f32screw_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, float, lyapunov_sample_f32screw>, detail::address(candidate), &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_storage_f64screw)
template <> class LolcStorage<Screw<double>> : public detail::LyapunovAccount<lyapunov_lolc_storage_f64screw> {
public:
    /* One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage. */
    template <class Function>
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort, Function &&function) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); detail::Candidate<Function> candidate = function; auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_lolc_storage_f64screw_step(&storage, &sample, &effort_form, &detail::call<std::remove_reference_t<decltype(candidate)>, double, lyapunov_sample_f64screw>, detail::address(candidate), &correction); return correction; }
};

/* LOLC with the credit of a wall's own damper while in contact (Dissipation::gated InContact): the paper's example 2. It can credit more than really burns; start with lolc. */
template <class Signal> class LolcInContact;

LYAPUNOV_ACCOUNT(lyapunov_lolc_in_contact_f32)
template <> class LolcInContact<float> : public detail::LyapunovAccount<lyapunov_lolc_in_contact_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_lolc_in_contact_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_in_contact_f64)
template <> class LolcInContact<double> : public detail::LyapunovAccount<lyapunov_lolc_in_contact_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_lolc_in_contact_f64_step(&storage, &sample, effort, &correction); return correction; }
};

/* LOLC over the paper's sampled work (Lolc::sampled), the power at the sampling instant. It misses what leaks between samples, and reads no `work`: look at the `accepted` of a reading. */
template <class Signal> class LolcSampled;

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f32)
template <> class LolcSampled<float> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_lolc_sampled_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f64)
template <> class LolcSampled<double> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_lolc_sampled_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f32x3)
template <> class LolcSampled<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_lolc_sampled_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f64x3)
template <> class LolcSampled<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_lolc_sampled_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f32x6)
template <> class LolcSampled<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_lolc_sampled_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f64x6)
template <> class LolcSampled<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_lolc_sampled_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f32screw)
template <> class LolcSampled<Screw<float>> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_lolc_sampled_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_sampled_f64screw)
template <> class LolcSampled<Screw<double>> : public detail::LyapunovAccount<lyapunov_lolc_sampled_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_lolc_sampled_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC with a compensated sum (Lolc::summed_in Compensated): in float too it keeps its digits for a year. */
template <class Signal> class LolcCompensated;

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f32)
template <> class LolcCompensated<float> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_lolc_compensated_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f64)
template <> class LolcCompensated<double> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_lolc_compensated_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f32x3)
template <> class LolcCompensated<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_lolc_compensated_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f64x3)
template <> class LolcCompensated<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_lolc_compensated_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f32x6)
template <> class LolcCompensated<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_lolc_compensated_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f64x6)
template <> class LolcCompensated<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_lolc_compensated_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f32screw)
template <> class LolcCompensated<Screw<float>> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_lolc_compensated_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_lolc_compensated_f64screw)
template <> class LolcCompensated<Screw<double>> : public detail::LyapunovAccount<lyapunov_lolc_compensated_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_lolc_compensated_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that carries a bounded credit from tick to tick (BoundedCredit). */
template <class Signal> class BoundedCredit;

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f32)
template <> class BoundedCredit<float> : public detail::LyapunovAccount<lyapunov_bounded_credit_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_bounded_credit_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f64)
template <> class BoundedCredit<double> : public detail::LyapunovAccount<lyapunov_bounded_credit_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_bounded_credit_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f32x3)
template <> class BoundedCredit<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_bounded_credit_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_bounded_credit_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f64x3)
template <> class BoundedCredit<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_bounded_credit_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_bounded_credit_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f32x6)
template <> class BoundedCredit<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_bounded_credit_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_bounded_credit_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f64x6)
template <> class BoundedCredit<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_bounded_credit_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_bounded_credit_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f32screw)
template <> class BoundedCredit<Screw<float>> : public detail::LyapunovAccount<lyapunov_bounded_credit_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_bounded_credit_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_bounded_credit_f64screw)
template <> class BoundedCredit<Screw<double>> : public detail::LyapunovAccount<lyapunov_bounded_credit_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_bounded_credit_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC whose credit expires after a window of ticks, kept in 8 slots (WindowedCredit): it expires between 7 and 8 times `ticks` later. */
template <class Signal> class WindowedCredit;

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f32)
template <> class WindowedCredit<float> : public detail::LyapunovAccount<lyapunov_windowed_credit_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_windowed_credit_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f64)
template <> class WindowedCredit<double> : public detail::LyapunovAccount<lyapunov_windowed_credit_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_windowed_credit_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f32x3)
template <> class WindowedCredit<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_windowed_credit_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_windowed_credit_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f64x3)
template <> class WindowedCredit<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_windowed_credit_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_windowed_credit_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f32x6)
template <> class WindowedCredit<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_windowed_credit_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_windowed_credit_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f64x6)
template <> class WindowedCredit<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_windowed_credit_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_windowed_credit_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f32screw)
template <> class WindowedCredit<Screw<float>> : public detail::LyapunovAccount<lyapunov_windowed_credit_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_windowed_credit_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_windowed_credit_f64screw)
template <> class WindowedCredit<Screw<double>> : public detail::LyapunovAccount<lyapunov_windowed_credit_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_windowed_credit_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that forfeits its credit whenever it comes into contact with a wall (ContactReset). */
template <class Signal> class ContactReset;

LYAPUNOV_ACCOUNT(lyapunov_contact_reset_f32)
template <> class ContactReset<float> : public detail::LyapunovAccount<lyapunov_contact_reset_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_contact_reset_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_contact_reset_f64)
template <> class ContactReset<double> : public detail::LyapunovAccount<lyapunov_contact_reset_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_contact_reset_f64_step(&storage, &sample, effort, &correction); return correction; }
};

/* LOLC that corrects only from a velocity on (VelocityThreshold). */
template <class Signal> class VelocityThreshold;

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f32)
template <> class VelocityThreshold<float> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_velocity_threshold_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f64)
template <> class VelocityThreshold<double> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_velocity_threshold_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f32x3)
template <> class VelocityThreshold<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_velocity_threshold_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f64x3)
template <> class VelocityThreshold<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_velocity_threshold_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f32x6)
template <> class VelocityThreshold<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_velocity_threshold_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f64x6)
template <> class VelocityThreshold<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_velocity_threshold_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f32screw)
template <> class VelocityThreshold<Screw<float>> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_velocity_threshold_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_velocity_threshold_f64screw)
template <> class VelocityThreshold<Screw<double>> : public detail::LyapunovAccount<lyapunov_velocity_threshold_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_velocity_threshold_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that pays a debt in parts (Spread). */
template <class Signal> class Spread;

LYAPUNOV_ACCOUNT(lyapunov_spread_f32)
template <> class Spread<float> : public detail::LyapunovAccount<lyapunov_spread_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_spread_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f64)
template <> class Spread<double> : public detail::LyapunovAccount<lyapunov_spread_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_spread_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f32x3)
template <> class Spread<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_spread_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_spread_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f64x3)
template <> class Spread<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_spread_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_spread_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f32x6)
template <> class Spread<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_spread_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_spread_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f64x6)
template <> class Spread<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_spread_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_spread_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f32screw)
template <> class Spread<Screw<float>> : public detail::LyapunovAccount<lyapunov_spread_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_spread_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_spread_f64screw)
template <> class Spread<Screw<double>> : public detail::LyapunovAccount<lyapunov_spread_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_spread_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC whose correction rises over the first ticks of each engagement (SoftStart). */
template <class Signal> class SoftStart;

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f32)
template <> class SoftStart<float> : public detail::LyapunovAccount<lyapunov_soft_start_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_soft_start_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f64)
template <> class SoftStart<double> : public detail::LyapunovAccount<lyapunov_soft_start_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_soft_start_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f32x3)
template <> class SoftStart<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_soft_start_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_soft_start_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f64x3)
template <> class SoftStart<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_soft_start_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_soft_start_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f32x6)
template <> class SoftStart<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_soft_start_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_soft_start_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f64x6)
template <> class SoftStart<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_soft_start_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_soft_start_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f32screw)
template <> class SoftStart<Screw<float>> : public detail::LyapunovAccount<lyapunov_soft_start_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_soft_start_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_soft_start_f64screw)
template <> class SoftStart<Screw<double>> : public detail::LyapunovAccount<lyapunov_soft_start_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_soft_start_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC whose correction grows no faster than a rate (RateLimit). */
template <class Signal> class RateLimit;

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f32)
template <> class RateLimit<float> : public detail::LyapunovAccount<lyapunov_rate_limit_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_rate_limit_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f64)
template <> class RateLimit<double> : public detail::LyapunovAccount<lyapunov_rate_limit_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_rate_limit_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f32x3)
template <> class RateLimit<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_rate_limit_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_rate_limit_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f64x3)
template <> class RateLimit<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_rate_limit_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_rate_limit_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f32x6)
template <> class RateLimit<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_rate_limit_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_rate_limit_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f64x6)
template <> class RateLimit<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_rate_limit_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_rate_limit_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f32screw)
template <> class RateLimit<Screw<float>> : public detail::LyapunovAccount<lyapunov_rate_limit_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_rate_limit_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_rate_limit_f64screw)
template <> class RateLimit<Screw<double>> : public detail::LyapunovAccount<lyapunov_rate_limit_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_rate_limit_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that dissipates on some axes more than on others (DirectedDamping with AxisWeights). */
template <class Signal> class AxisWeights;

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f32)
template <> class AxisWeights<float> : public detail::LyapunovAccount<lyapunov_axis_weights_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_axis_weights_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f64)
template <> class AxisWeights<double> : public detail::LyapunovAccount<lyapunov_axis_weights_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_axis_weights_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f32x3)
template <> class AxisWeights<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_axis_weights_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_axis_weights_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f64x3)
template <> class AxisWeights<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_axis_weights_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_axis_weights_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f32x6)
template <> class AxisWeights<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_axis_weights_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_axis_weights_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f64x6)
template <> class AxisWeights<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_axis_weights_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_axis_weights_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f32screw)
template <> class AxisWeights<Screw<float>> : public detail::LyapunovAccount<lyapunov_axis_weights_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_axis_weights_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_axis_weights_f64screw)
template <> class AxisWeights<Screw<double>> : public detail::LyapunovAccount<lyapunov_axis_weights_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_axis_weights_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that dissipates in one direction only (DirectedDamping with AlongDirection). */
template <class Signal> class AlongDirection;

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f32)
template <> class AlongDirection<float> : public detail::LyapunovAccount<lyapunov_along_direction_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_along_direction_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f64)
template <> class AlongDirection<double> : public detail::LyapunovAccount<lyapunov_along_direction_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_along_direction_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f32x3)
template <> class AlongDirection<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_along_direction_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_along_direction_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f64x3)
template <> class AlongDirection<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_along_direction_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_along_direction_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f32x6)
template <> class AlongDirection<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_along_direction_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_along_direction_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f64x6)
template <> class AlongDirection<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_along_direction_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_along_direction_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f32screw)
template <> class AlongDirection<Screw<float>> : public detail::LyapunovAccount<lyapunov_along_direction_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_along_direction_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_along_direction_f64screw)
template <> class AlongDirection<Screw<double>> : public detail::LyapunovAccount<lyapunov_along_direction_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_along_direction_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that slows coupled axes in proportion, by their inertia matrix (DirectedDamping with InertiaMetric). A posture that changes is told by `retune`, before each step. */
template <class Signal> class InertiaMetric;

LYAPUNOV_ACCOUNT(lyapunov_inertia_metric_f32x3)
template <> class InertiaMetric<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_inertia_metric_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_inertia_metric_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_inertia_metric_f64x3)
template <> class InertiaMetric<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_inertia_metric_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_inertia_metric_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_inertia_metric_f32x6)
template <> class InertiaMetric<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_inertia_metric_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_inertia_metric_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_inertia_metric_f64x6)
template <> class InertiaMetric<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_inertia_metric_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_inertia_metric_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC within what the joints of a mechanism can use in its present posture (InertiaLimit with JointInertia), which is told by `retune`, before each step. */
template <class Signal> class InertiaLimit;

LYAPUNOV_ACCOUNT(lyapunov_inertia_limit_f32x3)
template <> class InertiaLimit<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_inertia_limit_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_inertia_limit_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_inertia_limit_f64x3)
template <> class InertiaLimit<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_inertia_limit_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_inertia_limit_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_inertia_limit_f32x6)
template <> class InertiaLimit<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_inertia_limit_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_inertia_limit_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_inertia_limit_f64x6)
template <> class InertiaLimit<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_inertia_limit_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_inertia_limit_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that rejects samples and efforts which no device can have (Plausible). */
template <class Signal> class Plausible;

LYAPUNOV_ACCOUNT(lyapunov_plausible_f32)
template <> class Plausible<float> : public detail::LyapunovAccount<lyapunov_plausible_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_plausible_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f64)
template <> class Plausible<double> : public detail::LyapunovAccount<lyapunov_plausible_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_plausible_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f32x3)
template <> class Plausible<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_plausible_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_plausible_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f64x3)
template <> class Plausible<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_plausible_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_plausible_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f32x6)
template <> class Plausible<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_plausible_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_plausible_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f64x6)
template <> class Plausible<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_plausible_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_plausible_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f32screw)
template <> class Plausible<Screw<float>> : public detail::LyapunovAccount<lyapunov_plausible_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_plausible_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_plausible_f64screw)
template <> class Plausible<Screw<double>> : public detail::LyapunovAccount<lyapunov_plausible_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_plausible_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC that holds its last effort for a while without sound samples, then lets go, and comes back gently (Watchdog). */
template <class Signal> class Watchdog;

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f32)
template <> class Watchdog<float> : public detail::LyapunovAccount<lyapunov_watchdog_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_watchdog_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f64)
template <> class Watchdog<double> : public detail::LyapunovAccount<lyapunov_watchdog_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_watchdog_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f32x3)
template <> class Watchdog<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_watchdog_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_watchdog_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f64x3)
template <> class Watchdog<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_watchdog_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_watchdog_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f32x6)
template <> class Watchdog<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_watchdog_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_watchdog_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f64x6)
template <> class Watchdog<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_watchdog_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_watchdog_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f32screw)
template <> class Watchdog<Screw<float>> : public detail::LyapunovAccount<lyapunov_watchdog_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_watchdog_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_watchdog_f64screw)
template <> class Watchdog<Screw<double>> : public detail::LyapunovAccount<lyapunov_watchdog_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_watchdog_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* What a loop on real hardware wants at once: LOLC with a bounded credit, a correction that grows no faster than a rate, implausible samples rejected, and a watchdog (Watchdog of Plausible of RateLimit of BoundedCredit). */
template <class Signal> class Safeguarded;

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f32)
template <> class Safeguarded<float> : public detail::LyapunovAccount<lyapunov_safeguarded_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_safeguarded_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f64)
template <> class Safeguarded<double> : public detail::LyapunovAccount<lyapunov_safeguarded_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_safeguarded_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f32x3)
template <> class Safeguarded<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_safeguarded_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_safeguarded_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f64x3)
template <> class Safeguarded<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_safeguarded_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_safeguarded_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f32x6)
template <> class Safeguarded<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_safeguarded_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_safeguarded_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f64x6)
template <> class Safeguarded<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_safeguarded_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_safeguarded_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f32screw)
template <> class Safeguarded<Screw<float>> : public detail::LyapunovAccount<lyapunov_safeguarded_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_safeguarded_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_safeguarded_f64screw)
template <> class Safeguarded<Screw<double>> : public detail::LyapunovAccount<lyapunov_safeguarded_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_safeguarded_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC with a sum for each axis (PerAxis): what one axis absorbed does not pay for another. */
template <class Signal> class PerAxis;

LYAPUNOV_BLOCK(lyapunov_per_axis_f32x3)
template <> class PerAxis<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_per_axis_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_per_axis_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_BLOCK(lyapunov_per_axis_f64x3)
template <> class PerAxis<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_per_axis_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_per_axis_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_BLOCK(lyapunov_per_axis_f32x6)
template <> class PerAxis<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_per_axis_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_per_axis_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_BLOCK(lyapunov_per_axis_f64x6)
template <> class PerAxis<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_per_axis_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_per_axis_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC with a sum for translation and one for rotation (PerPart). */
template <class Signal> class PerPart;

LYAPUNOV_BLOCK(lyapunov_per_part_f32screw)
template <> class PerPart<Screw<float>> : public detail::LyapunovBlock<lyapunov_per_part_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_per_part_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_BLOCK(lyapunov_per_part_f64screw)
template <> class PerPart<Screw<double>> : public detail::LyapunovBlock<lyapunov_per_part_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_per_part_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* LOLC with one sum for a rigid body, and a damping limit for each part (DirectedDamping::within PartLimits). */
template <class Signal> class PartLimits;

LYAPUNOV_ACCOUNT(lyapunov_part_limits_f32screw)
template <> class PartLimits<Screw<float>> : public detail::LyapunovAccount<lyapunov_part_limits_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_part_limits_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_part_limits_f64screw)
template <> class PartLimits<Screw<double>> : public detail::LyapunovAccount<lyapunov_part_limits_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_part_limits_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Force bounding that keeps what free motion dissipated (ForceBound). */
template <class Signal> class ForceBound;

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f32)
template <> class ForceBound<float> : public detail::LyapunovAccount<lyapunov_force_bound_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_force_bound_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f64)
template <> class ForceBound<double> : public detail::LyapunovAccount<lyapunov_force_bound_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_force_bound_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f32x3)
template <> class ForceBound<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_force_bound_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_force_bound_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f64x3)
template <> class ForceBound<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_force_bound_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_force_bound_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f32x6)
template <> class ForceBound<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_force_bound_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_force_bound_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f64x6)
template <> class ForceBound<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_force_bound_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_force_bound_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f32screw)
template <> class ForceBound<Screw<float>> : public detail::LyapunovAccount<lyapunov_force_bound_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_force_bound_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bound_f64screw)
template <> class ForceBound<Screw<double>> : public detail::LyapunovAccount<lyapunov_force_bound_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_force_bound_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Force bounding that starts anew at each contact (ForceBounding). */
template <class Signal> class ForceBounding;

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f32)
template <> class ForceBounding<float> : public detail::LyapunovAccount<lyapunov_force_bounding_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_force_bounding_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f64)
template <> class ForceBounding<double> : public detail::LyapunovAccount<lyapunov_force_bounding_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_force_bounding_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f32x3)
template <> class ForceBounding<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_force_bounding_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_force_bounding_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f64x3)
template <> class ForceBounding<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_force_bounding_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_force_bounding_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f32x6)
template <> class ForceBounding<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_force_bounding_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_force_bounding_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f64x6)
template <> class ForceBounding<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_force_bounding_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_force_bounding_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f32screw)
template <> class ForceBounding<Screw<float>> : public detail::LyapunovAccount<lyapunov_force_bounding_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_force_bounding_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_force_bounding_f64screw)
template <> class ForceBounding<Screw<double>> : public detail::LyapunovAccount<lyapunov_force_bounding_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_force_bounding_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Energy tank (Tank): efforts that an empty tank cannot pay are reduced. */
template <class Signal> class Tank;

LYAPUNOV_ACCOUNT(lyapunov_tank_f32)
template <> class Tank<float> : public detail::LyapunovAccount<lyapunov_tank_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_tank_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f64)
template <> class Tank<double> : public detail::LyapunovAccount<lyapunov_tank_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_tank_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f32x3)
template <> class Tank<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_tank_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_tank_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f64x3)
template <> class Tank<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_tank_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_tank_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f32x6)
template <> class Tank<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_tank_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_tank_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f64x6)
template <> class Tank<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_tank_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_tank_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f32screw)
template <> class Tank<Screw<float>> : public detail::LyapunovAccount<lyapunov_tank_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_tank_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_tank_f64screw)
template <> class Tank<Screw<double>> : public detail::LyapunovAccount<lyapunov_tank_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_tank_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Energy tank with a port (EnergyTank): filled by what your controller dissipates, it lets pass as much of a wished input as it can pay for at the flow that you tell. It is asked, and has no samples. */
template <class Signal> class EnergyTank;

LYAPUNOV_BLOCK(lyapunov_energy_tank_f32)
template <> class EnergyTank<float> : public detail::LyapunovBlock<lyapunov_energy_tank_f32> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    float pass(float period, float dissipated, float wished, float flow) noexcept { auto passed = detail::unanswered<float>(); lyapunov_energy_tank_f32_pass(&storage, period, dissipated, wished, flow, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    float energy() const noexcept { return lyapunov_energy_tank_f32_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f64)
template <> class EnergyTank<double> : public detail::LyapunovBlock<lyapunov_energy_tank_f64> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    double pass(double period, double dissipated, double wished, double flow) noexcept { auto passed = detail::unanswered<double>(); lyapunov_energy_tank_f64_pass(&storage, period, dissipated, wished, flow, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    double energy() const noexcept { return lyapunov_energy_tank_f64_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f32x3)
template <> class EnergyTank<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_energy_tank_f32x3> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    lyapunov_f32x3 pass(float period, float dissipated, View<float, 3> wished, View<float, 3> flow) noexcept { const auto wished_form = detail::form<lyapunov_f32x3>(wished); const auto flow_form = detail::form<lyapunov_f32x3>(flow); auto passed = detail::unanswered<lyapunov_f32x3>(); lyapunov_energy_tank_f32x3_pass(&storage, period, dissipated, &wished_form, &flow_form, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    float energy() const noexcept { return lyapunov_energy_tank_f32x3_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f64x3)
template <> class EnergyTank<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_energy_tank_f64x3> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    lyapunov_f64x3 pass(double period, double dissipated, View<double, 3> wished, View<double, 3> flow) noexcept { const auto wished_form = detail::form<lyapunov_f64x3>(wished); const auto flow_form = detail::form<lyapunov_f64x3>(flow); auto passed = detail::unanswered<lyapunov_f64x3>(); lyapunov_energy_tank_f64x3_pass(&storage, period, dissipated, &wished_form, &flow_form, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    double energy() const noexcept { return lyapunov_energy_tank_f64x3_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f32x6)
template <> class EnergyTank<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_energy_tank_f32x6> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    lyapunov_f32x6 pass(float period, float dissipated, View<float, 6> wished, View<float, 6> flow) noexcept { const auto wished_form = detail::form<lyapunov_f32x6>(wished); const auto flow_form = detail::form<lyapunov_f32x6>(flow); auto passed = detail::unanswered<lyapunov_f32x6>(); lyapunov_energy_tank_f32x6_pass(&storage, period, dissipated, &wished_form, &flow_form, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    float energy() const noexcept { return lyapunov_energy_tank_f32x6_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f64x6)
template <> class EnergyTank<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_energy_tank_f64x6> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    lyapunov_f64x6 pass(double period, double dissipated, View<double, 6> wished, View<double, 6> flow) noexcept { const auto wished_form = detail::form<lyapunov_f64x6>(wished); const auto flow_form = detail::form<lyapunov_f64x6>(flow); auto passed = detail::unanswered<lyapunov_f64x6>(); lyapunov_energy_tank_f64x6_pass(&storage, period, dissipated, &wished_form, &flow_form, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    double energy() const noexcept { return lyapunov_energy_tank_f64x6_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f32screw)
template <> class EnergyTank<Screw<float>> : public detail::LyapunovBlock<lyapunov_energy_tank_f32screw> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    lyapunov_f32screw pass(float period, float dissipated, View<float, 6> wished, View<float, 6> flow) noexcept { const auto wished_form = detail::form<lyapunov_f32screw>(wished); const auto flow_form = detail::form<lyapunov_f32screw>(flow); auto passed = detail::unanswered<lyapunov_f32screw>(); lyapunov_energy_tank_f32screw_pass(&storage, period, dissipated, &wished_form, &flow_form, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    float energy() const noexcept { return lyapunov_energy_tank_f32screw_energy(&storage); }
};

LYAPUNOV_BLOCK(lyapunov_energy_tank_f64screw)
template <> class EnergyTank<Screw<double>> : public detail::LyapunovBlock<lyapunov_energy_tank_f64screw> {
public:
    /* The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts), while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is. */
    lyapunov_f64screw pass(double period, double dissipated, View<double, 6> wished, View<double, 6> flow) noexcept { const auto wished_form = detail::form<lyapunov_f64screw>(wished); const auto flow_form = detail::form<lyapunov_f64screw>(flow); auto passed = detail::unanswered<lyapunov_f64screw>(); lyapunov_energy_tank_f64screw_pass(&storage, period, dissipated, &wished_form, &flow_form, &passed); return passed; }
    /* The energy in it, J; NaN if the storage is not initialised. */
    double energy() const noexcept { return lyapunov_energy_tank_f64screw_energy(&storage); }
};

/* Energy-bounding algorithm (EnergyBounding), for a force that may act late. */
template <class Signal> class EnergyBounding;

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f32)
template <> class EnergyBounding<float> : public detail::LyapunovAccount<lyapunov_energy_bounding_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_energy_bounding_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f64)
template <> class EnergyBounding<double> : public detail::LyapunovAccount<lyapunov_energy_bounding_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_energy_bounding_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f32x3)
template <> class EnergyBounding<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_energy_bounding_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_energy_bounding_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f64x3)
template <> class EnergyBounding<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_energy_bounding_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_energy_bounding_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f32x6)
template <> class EnergyBounding<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_energy_bounding_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_energy_bounding_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f64x6)
template <> class EnergyBounding<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_energy_bounding_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_energy_bounding_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f32screw)
template <> class EnergyBounding<Screw<float>> : public detail::LyapunovAccount<lyapunov_energy_bounding_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_energy_bounding_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_energy_bounding_f64screw)
template <> class EnergyBounding<Screw<double>> : public detail::LyapunovAccount<lyapunov_energy_bounding_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_energy_bounding_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Least-norm filter (LeastNorm): the least damping that keeps the observed energy above a decaying barrier. */
template <class Signal> class LeastNorm;

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f32)
template <> class LeastNorm<float> : public detail::LyapunovAccount<lyapunov_least_norm_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_least_norm_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f64)
template <> class LeastNorm<double> : public detail::LyapunovAccount<lyapunov_least_norm_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_least_norm_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f32x3)
template <> class LeastNorm<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_least_norm_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_least_norm_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f64x3)
template <> class LeastNorm<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_least_norm_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_least_norm_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f32x6)
template <> class LeastNorm<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_least_norm_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_least_norm_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f64x6)
template <> class LeastNorm<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_least_norm_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_least_norm_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f32screw)
template <> class LeastNorm<Screw<float>> : public detail::LyapunovAccount<lyapunov_least_norm_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_least_norm_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_least_norm_f64screw)
template <> class LeastNorm<Screw<double>> : public detail::LyapunovAccount<lyapunov_least_norm_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_least_norm_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Slope bound (SlopeBound): efforts change no faster with the displacement than a slope. */
template <class Signal> class SlopeBound;

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f32)
template <> class SlopeBound<float> : public detail::LyapunovAccount<lyapunov_slope_bound_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_slope_bound_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f64)
template <> class SlopeBound<double> : public detail::LyapunovAccount<lyapunov_slope_bound_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_slope_bound_f64_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f32x3)
template <> class SlopeBound<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_slope_bound_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_slope_bound_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f64x3)
template <> class SlopeBound<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_slope_bound_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_slope_bound_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f32x6)
template <> class SlopeBound<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_slope_bound_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_slope_bound_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f64x6)
template <> class SlopeBound<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_slope_bound_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_slope_bound_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f32screw)
template <> class SlopeBound<Screw<float>> : public detail::LyapunovAccount<lyapunov_slope_bound_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_slope_bound_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_slope_bound_f64screw)
template <> class SlopeBound<Screw<double>> : public detail::LyapunovAccount<lyapunov_slope_bound_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_slope_bound_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
};

/* Memory-based passivation (MemoryBased): forces on the way out no larger than those kept from the way in, in 64 cells. */
template <class Signal> class MemoryBased;

LYAPUNOV_ACCOUNT(lyapunov_memory_based_f32)
template <> class MemoryBased<float> : public detail::LyapunovAccount<lyapunov_memory_based_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_memory_based_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_ACCOUNT(lyapunov_memory_based_f64)
template <> class MemoryBased<double> : public detail::LyapunovAccount<lyapunov_memory_based_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_memory_based_f64_step(&storage, &sample, effort, &correction); return correction; }
};

/* Path memory (PathMemory): energies on the way out no larger than those kept from the way in, in 64 cells. */
template <class Signal> class PathMemory;

LYAPUNOV_BLOCK(lyapunov_path_memory_f32)
template <> class PathMemory<float> : public detail::LyapunovBlock<lyapunov_path_memory_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_path_memory_f32_step(&storage, &sample, effort, &correction); return correction; }
};

LYAPUNOV_BLOCK(lyapunov_path_memory_f64)
template <> class PathMemory<double> : public detail::LyapunovBlock<lyapunov_path_memory_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_path_memory_f64_step(&storage, &sample, effort, &correction); return correction; }
};

/* Side of a two-port (TwoPortSide): send `absorbed` to the other side on every tick, and give `receive` what came. Where force comes in and motion goes out, as at a slave, `velocity` of the sample is the measured force (N), `displacement` its impulse (N.s), `position` the sum of the impulses, `applied` the velocity that was applied (m/s); efforts in and out are velocities, `alpha` and the limit mobilities, m/(N.s). README.md has it as a table. */
template <class Signal> class TwoPortSide;

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f32)
template <> class TwoPortSide<float> : public detail::LyapunovAccount<lyapunov_two_port_side_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_two_port_side_f32_step(&storage, &sample, effort, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_two_port_side_f32_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f32_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f64)
template <> class TwoPortSide<double> : public detail::LyapunovAccount<lyapunov_two_port_side_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_two_port_side_f64_step(&storage, &sample, effort, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_two_port_side_f64_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f64_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f32x3)
template <> class TwoPortSide<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_two_port_side_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_two_port_side_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_two_port_side_f32x3_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f32x3_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f64x3)
template <> class TwoPortSide<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_two_port_side_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_two_port_side_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_two_port_side_f64x3_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f64x3_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f32x6)
template <> class TwoPortSide<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_two_port_side_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_two_port_side_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_two_port_side_f32x6_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f32x6_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f64x6)
template <> class TwoPortSide<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_two_port_side_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_two_port_side_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_two_port_side_f64x6_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f64x6_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f32screw)
template <> class TwoPortSide<Screw<float>> : public detail::LyapunovAccount<lyapunov_two_port_side_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_two_port_side_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_two_port_side_f32screw_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f32screw_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_port_side_f64screw)
template <> class TwoPortSide<Screw<double>> : public detail::LyapunovAccount<lyapunov_two_port_side_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_two_port_side_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_two_port_side_f64screw_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_port_side_f64screw_receive(&storage, energy)); }
};

/* Side of a two-port with an admittance, which makes up for the drift of its commanded motion (DriftCompensated). `velocity` of the sample is the measured force (N), `displacement` its impulse (N.s), `position` the sum of the impulses, `applied` the velocity that was applied (m/s); efforts in and out are velocities, `alpha` is a mobility, m/(N.s). README.md has it as a table. */
template <class Signal> class DriftCompensated;

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f32)
template <> class DriftCompensated<float> : public detail::LyapunovAccount<lyapunov_drift_compensated_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_drift_compensated_f32_step(&storage, &sample, effort, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_drift_compensated_f32_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f32_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f64)
template <> class DriftCompensated<double> : public detail::LyapunovAccount<lyapunov_drift_compensated_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_drift_compensated_f64_step(&storage, &sample, effort, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_drift_compensated_f64_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f64_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f32x3)
template <> class DriftCompensated<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_drift_compensated_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_drift_compensated_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_drift_compensated_f32x3_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f32x3_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f64x3)
template <> class DriftCompensated<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_drift_compensated_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_drift_compensated_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_drift_compensated_f64x3_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f64x3_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f32x6)
template <> class DriftCompensated<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_drift_compensated_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_drift_compensated_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_drift_compensated_f32x6_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f32x6_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f64x6)
template <> class DriftCompensated<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_drift_compensated_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_drift_compensated_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_drift_compensated_f64x6_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f64x6_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f32screw)
template <> class DriftCompensated<Screw<float>> : public detail::LyapunovAccount<lyapunov_drift_compensated_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_drift_compensated_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    float absorbed() const noexcept { return lyapunov_drift_compensated_f32screw_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f32screw_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_drift_compensated_f64screw)
template <> class DriftCompensated<Screw<double>> : public detail::LyapunovAccount<lyapunov_drift_compensated_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_drift_compensated_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised. */
    double absorbed() const noexcept { return lyapunov_drift_compensated_f64screw_absorbed(&storage); }
    /* The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_drift_compensated_f64screw_receive(&storage, energy)); }
};

/* Side of a two-layer architecture (TwoLayer): send `sent` to the other side, and give `receive` what came. A slave has a level and a gain of 0. */
template <class Signal> class TwoLayer;

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f32)
template <> class TwoLayer<float> : public detail::LyapunovAccount<lyapunov_two_layer_f32> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32 step(const lyapunov_sample_f32 &sample, float effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f32>(); lyapunov_two_layer_f32_step(&storage, &sample, effort, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    float sent() const noexcept { return lyapunov_two_layer_f32_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f32_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f64)
template <> class TwoLayer<double> : public detail::LyapunovAccount<lyapunov_two_layer_f64> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64 step(const lyapunov_sample_f64 &sample, double effort) noexcept { auto correction = detail::unanswered<lyapunov_correction_f64>(); lyapunov_two_layer_f64_step(&storage, &sample, effort, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    double sent() const noexcept { return lyapunov_two_layer_f64_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f64_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f32x3)
template <> class TwoLayer<Axes<float, 3>> : public detail::LyapunovAccount<lyapunov_two_layer_f32x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x3 step(const lyapunov_sample_f32x3 &sample, View<float, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x3>(); lyapunov_two_layer_f32x3_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    float sent() const noexcept { return lyapunov_two_layer_f32x3_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f32x3_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f64x3)
template <> class TwoLayer<Axes<double, 3>> : public detail::LyapunovAccount<lyapunov_two_layer_f64x3> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x3 step(const lyapunov_sample_f64x3 &sample, View<double, 3> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x3>(); lyapunov_two_layer_f64x3_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    double sent() const noexcept { return lyapunov_two_layer_f64x3_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f64x3_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f32x6)
template <> class TwoLayer<Axes<float, 6>> : public detail::LyapunovAccount<lyapunov_two_layer_f32x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32x6 step(const lyapunov_sample_f32x6 &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f32x6>(); lyapunov_two_layer_f32x6_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    float sent() const noexcept { return lyapunov_two_layer_f32x6_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f32x6_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f64x6)
template <> class TwoLayer<Axes<double, 6>> : public detail::LyapunovAccount<lyapunov_two_layer_f64x6> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64x6 step(const lyapunov_sample_f64x6 &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto correction = detail::unanswered<lyapunov_correction_f64x6>(); lyapunov_two_layer_f64x6_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    double sent() const noexcept { return lyapunov_two_layer_f64x6_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f64x6_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f32screw)
template <> class TwoLayer<Screw<float>> : public detail::LyapunovAccount<lyapunov_two_layer_f32screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f32screw step(const lyapunov_sample_f32screw &sample, View<float, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f32screw>(); lyapunov_two_layer_f32screw_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    float sent() const noexcept { return lyapunov_two_layer_f32screw_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(float energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f32screw_receive(&storage, energy)); }
};

LYAPUNOV_ACCOUNT(lyapunov_two_layer_f64screw)
template <> class TwoLayer<Screw<double>> : public detail::LyapunovAccount<lyapunov_two_layer_f64screw> {
public:
    /* One tick: what the other side did, and the effort that your controller asks for; out comes the correction. */
    lyapunov_correction_f64screw step(const lyapunov_sample_f64screw &sample, View<double, 6> effort) noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto correction = detail::unanswered<lyapunov_correction_f64screw>(); lyapunov_two_layer_f64screw_step(&storage, &sample, &effort_form, &correction); return correction; }
    /* What this side sent since the start, J, to be told the other; NaN if the storage is not initialised. */
    double sent() const noexcept { return lyapunov_two_layer_f64screw_sent(&storage); }
    /* The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite, or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are ignored: check packets before, by a checksum. */
    Code receive(double energy) noexcept { return static_cast<Code>(lyapunov_two_layer_f64screw_receive(&storage, energy)); }
};

/* Wave transformation (WaveTransform): waves of a flow v and an effort F, and the other way round. With the impedance b the wave there is (b v + F) / sqrt(2 b), the one back (b v - F) / sqrt(2 b), and the power F v is (there^2 - back^2) / 2. It has no memory, and what is not finite comes out so. */
template <class Signal> class WaveTransform;

LYAPUNOV_BLOCK(lyapunov_wave_transform_f32)
template <> class WaveTransform<float> : public detail::LyapunovBlock<lyapunov_wave_transform_f32> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f32 encode(float flow, float effort) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f32>(); lyapunov_wave_transform_f32_encode(&storage, flow, effort, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f32 decode(float there, float back) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f32>(); lyapunov_wave_transform_f32_decode(&storage, there, back, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f32 effort(float flow, float back) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f32>(); lyapunov_wave_transform_f32_effort(&storage, flow, back, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f32 flow(float effort, float there) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f32>(); lyapunov_wave_transform_f32_flow(&storage, effort, there, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f64)
template <> class WaveTransform<double> : public detail::LyapunovBlock<lyapunov_wave_transform_f64> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f64 encode(double flow, double effort) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f64>(); lyapunov_wave_transform_f64_encode(&storage, flow, effort, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f64 decode(double there, double back) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f64>(); lyapunov_wave_transform_f64_decode(&storage, there, back, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f64 effort(double flow, double back) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f64>(); lyapunov_wave_transform_f64_effort(&storage, flow, back, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f64 flow(double effort, double there) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f64>(); lyapunov_wave_transform_f64_flow(&storage, effort, there, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f32x3)
template <> class WaveTransform<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_wave_transform_f32x3> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f32x3 encode(View<float, 3> flow, View<float, 3> effort) const noexcept { const auto flow_form = detail::form<lyapunov_f32x3>(flow); const auto effort_form = detail::form<lyapunov_f32x3>(effort); auto wave = detail::unanswered<lyapunov_wave_f32x3>(); lyapunov_wave_transform_f32x3_encode(&storage, &flow_form, &effort_form, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f32x3 decode(View<float, 3> there, View<float, 3> back) const noexcept { const auto there_form = detail::form<lyapunov_f32x3>(there); const auto back_form = detail::form<lyapunov_f32x3>(back); auto wave = detail::unanswered<lyapunov_wave_f32x3>(); lyapunov_wave_transform_f32x3_decode(&storage, &there_form, &back_form, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f32x3 effort(View<float, 3> flow, View<float, 3> back) const noexcept { const auto flow_form = detail::form<lyapunov_f32x3>(flow); const auto back_form = detail::form<lyapunov_f32x3>(back); auto wave = detail::unanswered<lyapunov_wave_f32x3>(); lyapunov_wave_transform_f32x3_effort(&storage, &flow_form, &back_form, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f32x3 flow(View<float, 3> effort, View<float, 3> there) const noexcept { const auto effort_form = detail::form<lyapunov_f32x3>(effort); const auto there_form = detail::form<lyapunov_f32x3>(there); auto wave = detail::unanswered<lyapunov_wave_f32x3>(); lyapunov_wave_transform_f32x3_flow(&storage, &effort_form, &there_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f64x3)
template <> class WaveTransform<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_wave_transform_f64x3> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f64x3 encode(View<double, 3> flow, View<double, 3> effort) const noexcept { const auto flow_form = detail::form<lyapunov_f64x3>(flow); const auto effort_form = detail::form<lyapunov_f64x3>(effort); auto wave = detail::unanswered<lyapunov_wave_f64x3>(); lyapunov_wave_transform_f64x3_encode(&storage, &flow_form, &effort_form, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f64x3 decode(View<double, 3> there, View<double, 3> back) const noexcept { const auto there_form = detail::form<lyapunov_f64x3>(there); const auto back_form = detail::form<lyapunov_f64x3>(back); auto wave = detail::unanswered<lyapunov_wave_f64x3>(); lyapunov_wave_transform_f64x3_decode(&storage, &there_form, &back_form, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f64x3 effort(View<double, 3> flow, View<double, 3> back) const noexcept { const auto flow_form = detail::form<lyapunov_f64x3>(flow); const auto back_form = detail::form<lyapunov_f64x3>(back); auto wave = detail::unanswered<lyapunov_wave_f64x3>(); lyapunov_wave_transform_f64x3_effort(&storage, &flow_form, &back_form, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f64x3 flow(View<double, 3> effort, View<double, 3> there) const noexcept { const auto effort_form = detail::form<lyapunov_f64x3>(effort); const auto there_form = detail::form<lyapunov_f64x3>(there); auto wave = detail::unanswered<lyapunov_wave_f64x3>(); lyapunov_wave_transform_f64x3_flow(&storage, &effort_form, &there_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f32x6)
template <> class WaveTransform<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_wave_transform_f32x6> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f32x6 encode(View<float, 6> flow, View<float, 6> effort) const noexcept { const auto flow_form = detail::form<lyapunov_f32x6>(flow); const auto effort_form = detail::form<lyapunov_f32x6>(effort); auto wave = detail::unanswered<lyapunov_wave_f32x6>(); lyapunov_wave_transform_f32x6_encode(&storage, &flow_form, &effort_form, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f32x6 decode(View<float, 6> there, View<float, 6> back) const noexcept { const auto there_form = detail::form<lyapunov_f32x6>(there); const auto back_form = detail::form<lyapunov_f32x6>(back); auto wave = detail::unanswered<lyapunov_wave_f32x6>(); lyapunov_wave_transform_f32x6_decode(&storage, &there_form, &back_form, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f32x6 effort(View<float, 6> flow, View<float, 6> back) const noexcept { const auto flow_form = detail::form<lyapunov_f32x6>(flow); const auto back_form = detail::form<lyapunov_f32x6>(back); auto wave = detail::unanswered<lyapunov_wave_f32x6>(); lyapunov_wave_transform_f32x6_effort(&storage, &flow_form, &back_form, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f32x6 flow(View<float, 6> effort, View<float, 6> there) const noexcept { const auto effort_form = detail::form<lyapunov_f32x6>(effort); const auto there_form = detail::form<lyapunov_f32x6>(there); auto wave = detail::unanswered<lyapunov_wave_f32x6>(); lyapunov_wave_transform_f32x6_flow(&storage, &effort_form, &there_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f64x6)
template <> class WaveTransform<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_wave_transform_f64x6> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f64x6 encode(View<double, 6> flow, View<double, 6> effort) const noexcept { const auto flow_form = detail::form<lyapunov_f64x6>(flow); const auto effort_form = detail::form<lyapunov_f64x6>(effort); auto wave = detail::unanswered<lyapunov_wave_f64x6>(); lyapunov_wave_transform_f64x6_encode(&storage, &flow_form, &effort_form, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f64x6 decode(View<double, 6> there, View<double, 6> back) const noexcept { const auto there_form = detail::form<lyapunov_f64x6>(there); const auto back_form = detail::form<lyapunov_f64x6>(back); auto wave = detail::unanswered<lyapunov_wave_f64x6>(); lyapunov_wave_transform_f64x6_decode(&storage, &there_form, &back_form, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f64x6 effort(View<double, 6> flow, View<double, 6> back) const noexcept { const auto flow_form = detail::form<lyapunov_f64x6>(flow); const auto back_form = detail::form<lyapunov_f64x6>(back); auto wave = detail::unanswered<lyapunov_wave_f64x6>(); lyapunov_wave_transform_f64x6_effort(&storage, &flow_form, &back_form, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f64x6 flow(View<double, 6> effort, View<double, 6> there) const noexcept { const auto effort_form = detail::form<lyapunov_f64x6>(effort); const auto there_form = detail::form<lyapunov_f64x6>(there); auto wave = detail::unanswered<lyapunov_wave_f64x6>(); lyapunov_wave_transform_f64x6_flow(&storage, &effort_form, &there_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f32screw)
template <> class WaveTransform<Screw<float>> : public detail::LyapunovBlock<lyapunov_wave_transform_f32screw> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f32screw encode(View<float, 6> flow, View<float, 6> effort) const noexcept { const auto flow_form = detail::form<lyapunov_f32screw>(flow); const auto effort_form = detail::form<lyapunov_f32screw>(effort); auto wave = detail::unanswered<lyapunov_wave_f32screw>(); lyapunov_wave_transform_f32screw_encode(&storage, &flow_form, &effort_form, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f32screw decode(View<float, 6> there, View<float, 6> back) const noexcept { const auto there_form = detail::form<lyapunov_f32screw>(there); const auto back_form = detail::form<lyapunov_f32screw>(back); auto wave = detail::unanswered<lyapunov_wave_f32screw>(); lyapunov_wave_transform_f32screw_decode(&storage, &there_form, &back_form, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f32screw effort(View<float, 6> flow, View<float, 6> back) const noexcept { const auto flow_form = detail::form<lyapunov_f32screw>(flow); const auto back_form = detail::form<lyapunov_f32screw>(back); auto wave = detail::unanswered<lyapunov_wave_f32screw>(); lyapunov_wave_transform_f32screw_effort(&storage, &flow_form, &back_form, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f32screw flow(View<float, 6> effort, View<float, 6> there) const noexcept { const auto effort_form = detail::form<lyapunov_f32screw>(effort); const auto there_form = detail::form<lyapunov_f32screw>(there); auto wave = detail::unanswered<lyapunov_wave_f32screw>(); lyapunov_wave_transform_f32screw_flow(&storage, &effort_form, &there_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_transform_f64screw)
template <> class WaveTransform<Screw<double>> : public detail::LyapunovBlock<lyapunov_wave_transform_f64screw> {
public:
    /* The waves of a flow and an effort. */
    lyapunov_wave_f64screw encode(View<double, 6> flow, View<double, 6> effort) const noexcept { const auto flow_form = detail::form<lyapunov_f64screw>(flow); const auto effort_form = detail::form<lyapunov_f64screw>(effort); auto wave = detail::unanswered<lyapunov_wave_f64screw>(); lyapunov_wave_transform_f64screw_encode(&storage, &flow_form, &effort_form, &wave); return wave; }
    /* The flow and the effort of the waves there and back. */
    lyapunov_wave_f64screw decode(View<double, 6> there, View<double, 6> back) const noexcept { const auto there_form = detail::form<lyapunov_f64screw>(there); const auto back_form = detail::form<lyapunov_f64screw>(back); auto wave = detail::unanswered<lyapunov_wave_f64screw>(); lyapunov_wave_transform_f64screw_decode(&storage, &there_form, &back_form, &wave); return wave; }
    /* The effort where the flow is known and the wave `back` came in, and the wave that goes there. */
    lyapunov_wave_f64screw effort(View<double, 6> flow, View<double, 6> back) const noexcept { const auto flow_form = detail::form<lyapunov_f64screw>(flow); const auto back_form = detail::form<lyapunov_f64screw>(back); auto wave = detail::unanswered<lyapunov_wave_f64screw>(); lyapunov_wave_transform_f64screw_effort(&storage, &flow_form, &back_form, &wave); return wave; }
    /* The flow where the effort is known and the wave `there` came in, and the wave that goes back. */
    lyapunov_wave_f64screw flow(View<double, 6> effort, View<double, 6> there) const noexcept { const auto effort_form = detail::form<lyapunov_f64screw>(effort); const auto there_form = detail::form<lyapunov_f64screw>(there); auto wave = detail::unanswered<lyapunov_wave_f64screw>(); lyapunov_wave_transform_f64screw_flow(&storage, &effort_form, &there_form, &wave); return wave; }
};

/* Low pass in the path of a wave (WaveFilter). */
template <class Signal> class WaveFilter;

LYAPUNOV_BLOCK(lyapunov_wave_filter_f32)
template <> class WaveFilter<float> : public detail::LyapunovBlock<lyapunov_wave_filter_f32> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    float pass(float wave) noexcept { auto sent = detail::unanswered<float>(); lyapunov_wave_filter_f32_pass(&storage, wave, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f64)
template <> class WaveFilter<double> : public detail::LyapunovBlock<lyapunov_wave_filter_f64> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    double pass(double wave) noexcept { auto sent = detail::unanswered<double>(); lyapunov_wave_filter_f64_pass(&storage, wave, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f32x3)
template <> class WaveFilter<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_wave_filter_f32x3> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    lyapunov_f32x3 pass(View<float, 3> wave) noexcept { const auto wave_form = detail::form<lyapunov_f32x3>(wave); auto sent = detail::unanswered<lyapunov_f32x3>(); lyapunov_wave_filter_f32x3_pass(&storage, &wave_form, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f64x3)
template <> class WaveFilter<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_wave_filter_f64x3> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    lyapunov_f64x3 pass(View<double, 3> wave) noexcept { const auto wave_form = detail::form<lyapunov_f64x3>(wave); auto sent = detail::unanswered<lyapunov_f64x3>(); lyapunov_wave_filter_f64x3_pass(&storage, &wave_form, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f32x6)
template <> class WaveFilter<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_wave_filter_f32x6> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    lyapunov_f32x6 pass(View<float, 6> wave) noexcept { const auto wave_form = detail::form<lyapunov_f32x6>(wave); auto sent = detail::unanswered<lyapunov_f32x6>(); lyapunov_wave_filter_f32x6_pass(&storage, &wave_form, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f64x6)
template <> class WaveFilter<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_wave_filter_f64x6> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    lyapunov_f64x6 pass(View<double, 6> wave) noexcept { const auto wave_form = detail::form<lyapunov_f64x6>(wave); auto sent = detail::unanswered<lyapunov_f64x6>(); lyapunov_wave_filter_f64x6_pass(&storage, &wave_form, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f32screw)
template <> class WaveFilter<Screw<float>> : public detail::LyapunovBlock<lyapunov_wave_filter_f32screw> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    lyapunov_f32screw pass(View<float, 6> wave) noexcept { const auto wave_form = detail::form<lyapunov_f32screw>(wave); auto sent = detail::unanswered<lyapunov_f32screw>(); lyapunov_wave_filter_f32screw_pass(&storage, &wave_form, &sent); return sent; }
};

LYAPUNOV_BLOCK(lyapunov_wave_filter_f64screw)
template <> class WaveFilter<Screw<double>> : public detail::LyapunovBlock<lyapunov_wave_filter_f64screw> {
public:
    /* The wave to send for `wave`. One that is not finite is passed over. */
    lyapunov_f64screw pass(View<double, 6> wave) noexcept { const auto wave_form = detail::form<lyapunov_f64screw>(wave); auto sent = detail::unanswered<lyapunov_f64screw>(); lyapunov_wave_filter_f64screw_pass(&storage, &wave_form, &sent); return sent; }
};

/* Slave behind a wave (WaveFollower): a spring and a damper that solve for the flow they are commanded. A damping as large as the impedance is matched, and reflects nothing. It has no memory. */
template <class Signal> class WaveFollower;

LYAPUNOV_BLOCK(lyapunov_wave_follower_f32)
template <> class WaveFollower<float> : public detail::LyapunovBlock<lyapunov_wave_follower_f32> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f32 follow(float there, float error, float velocity) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f32>(); lyapunov_wave_follower_f32_follow(&storage, there, error, velocity, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f64)
template <> class WaveFollower<double> : public detail::LyapunovBlock<lyapunov_wave_follower_f64> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f64 follow(double there, double error, double velocity) const noexcept { auto wave = detail::unanswered<lyapunov_wave_f64>(); lyapunov_wave_follower_f64_follow(&storage, there, error, velocity, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f32x3)
template <> class WaveFollower<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_wave_follower_f32x3> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f32x3 follow(View<float, 3> there, View<float, 3> error, View<float, 3> velocity) const noexcept { const auto there_form = detail::form<lyapunov_f32x3>(there); const auto error_form = detail::form<lyapunov_f32x3>(error); const auto velocity_form = detail::form<lyapunov_f32x3>(velocity); auto wave = detail::unanswered<lyapunov_wave_f32x3>(); lyapunov_wave_follower_f32x3_follow(&storage, &there_form, &error_form, &velocity_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f64x3)
template <> class WaveFollower<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_wave_follower_f64x3> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f64x3 follow(View<double, 3> there, View<double, 3> error, View<double, 3> velocity) const noexcept { const auto there_form = detail::form<lyapunov_f64x3>(there); const auto error_form = detail::form<lyapunov_f64x3>(error); const auto velocity_form = detail::form<lyapunov_f64x3>(velocity); auto wave = detail::unanswered<lyapunov_wave_f64x3>(); lyapunov_wave_follower_f64x3_follow(&storage, &there_form, &error_form, &velocity_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f32x6)
template <> class WaveFollower<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_wave_follower_f32x6> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f32x6 follow(View<float, 6> there, View<float, 6> error, View<float, 6> velocity) const noexcept { const auto there_form = detail::form<lyapunov_f32x6>(there); const auto error_form = detail::form<lyapunov_f32x6>(error); const auto velocity_form = detail::form<lyapunov_f32x6>(velocity); auto wave = detail::unanswered<lyapunov_wave_f32x6>(); lyapunov_wave_follower_f32x6_follow(&storage, &there_form, &error_form, &velocity_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f64x6)
template <> class WaveFollower<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_wave_follower_f64x6> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f64x6 follow(View<double, 6> there, View<double, 6> error, View<double, 6> velocity) const noexcept { const auto there_form = detail::form<lyapunov_f64x6>(there); const auto error_form = detail::form<lyapunov_f64x6>(error); const auto velocity_form = detail::form<lyapunov_f64x6>(velocity); auto wave = detail::unanswered<lyapunov_wave_f64x6>(); lyapunov_wave_follower_f64x6_follow(&storage, &there_form, &error_form, &velocity_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f32screw)
template <> class WaveFollower<Screw<float>> : public detail::LyapunovBlock<lyapunov_wave_follower_f32screw> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f32screw follow(View<float, 6> there, View<float, 6> error, View<float, 6> velocity) const noexcept { const auto there_form = detail::form<lyapunov_f32screw>(there); const auto error_form = detail::form<lyapunov_f32screw>(error); const auto velocity_form = detail::form<lyapunov_f32screw>(velocity); auto wave = detail::unanswered<lyapunov_wave_f32screw>(); lyapunov_wave_follower_f32screw_follow(&storage, &there_form, &error_form, &velocity_form, &wave); return wave; }
};

LYAPUNOV_BLOCK(lyapunov_wave_follower_f64screw)
template <> class WaveFollower<Screw<double>> : public detail::LyapunovBlock<lyapunov_wave_follower_f64screw> {
public:
    /* The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back. */
    lyapunov_wave_f64screw follow(View<double, 6> there, View<double, 6> error, View<double, 6> velocity) const noexcept { const auto there_form = detail::form<lyapunov_f64screw>(there); const auto error_form = detail::form<lyapunov_f64screw>(error); const auto velocity_form = detail::form<lyapunov_f64screw>(velocity); auto wave = detail::unanswered<lyapunov_wave_f64screw>(); lyapunov_wave_follower_f64screw_follow(&storage, &there_form, &error_form, &velocity_form, &wave); return wave; }
};

/* Observer alone (Observer): sums the port's energy and what the device's own damper burns, and changes no effort. */
template <class Signal> class Observer;

LYAPUNOV_BLOCK(lyapunov_observer_f32)
template <> class Observer<float> : public detail::LyapunovBlock<lyapunov_observer_f32> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    float observe(const lyapunov_sample_f32 &sample) noexcept { auto energy = detail::unanswered<float>(); lyapunov_observer_f32_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f64)
template <> class Observer<double> : public detail::LyapunovBlock<lyapunov_observer_f64> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    double observe(const lyapunov_sample_f64 &sample) noexcept { auto energy = detail::unanswered<double>(); lyapunov_observer_f64_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f32x3)
template <> class Observer<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_observer_f32x3> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    float observe(const lyapunov_sample_f32x3 &sample) noexcept { auto energy = detail::unanswered<float>(); lyapunov_observer_f32x3_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f64x3)
template <> class Observer<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_observer_f64x3> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    double observe(const lyapunov_sample_f64x3 &sample) noexcept { auto energy = detail::unanswered<double>(); lyapunov_observer_f64x3_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f32x6)
template <> class Observer<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_observer_f32x6> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    float observe(const lyapunov_sample_f32x6 &sample) noexcept { auto energy = detail::unanswered<float>(); lyapunov_observer_f32x6_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f64x6)
template <> class Observer<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_observer_f64x6> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    double observe(const lyapunov_sample_f64x6 &sample) noexcept { auto energy = detail::unanswered<double>(); lyapunov_observer_f64x6_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f32screw)
template <> class Observer<Screw<float>> : public detail::LyapunovBlock<lyapunov_observer_f32screw> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    float observe(const lyapunov_sample_f32screw &sample) noexcept { auto energy = detail::unanswered<float>(); lyapunov_observer_f32screw_observe(&storage, &sample, &energy); return energy; }
};

LYAPUNOV_BLOCK(lyapunov_observer_f64screw)
template <> class Observer<Screw<double>> : public detail::LyapunovBlock<lyapunov_observer_f64screw> {
public:
    /* Books a sample; writes the observed energy, J. A decrease that is not finite is left out. */
    double observe(const lyapunov_sample_f64screw &sample) noexcept { auto energy = detail::unanswered<double>(); lyapunov_observer_f64screw_observe(&storage, &sample, &energy); return energy; }
};

/* Run-time summary (EnergyMeter): energies and counts of all ticks so far, in sums that keep their digits for a year. */
template <class Signal> class EnergyMeter;

LYAPUNOV_BLOCK(lyapunov_energy_meter_f32)
template <> class EnergyMeter<float> : public detail::LyapunovBlock<lyapunov_energy_meter_f32> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f32 &sample, const lyapunov_correction_f32 &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f32_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f32 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f32>(); lyapunov_energy_meter_f32_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f64)
template <> class EnergyMeter<double> : public detail::LyapunovBlock<lyapunov_energy_meter_f64> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f64 &sample, const lyapunov_correction_f64 &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f64_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f64 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f64>(); lyapunov_energy_meter_f64_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f32x3)
template <> class EnergyMeter<Axes<float, 3>> : public detail::LyapunovBlock<lyapunov_energy_meter_f32x3> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f32x3 &sample, const lyapunov_correction_f32x3 &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f32x3_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f32 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f32>(); lyapunov_energy_meter_f32x3_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f64x3)
template <> class EnergyMeter<Axes<double, 3>> : public detail::LyapunovBlock<lyapunov_energy_meter_f64x3> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f64x3 &sample, const lyapunov_correction_f64x3 &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f64x3_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f64 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f64>(); lyapunov_energy_meter_f64x3_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f32x6)
template <> class EnergyMeter<Axes<float, 6>> : public detail::LyapunovBlock<lyapunov_energy_meter_f32x6> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f32x6 &sample, const lyapunov_correction_f32x6 &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f32x6_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f32 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f32>(); lyapunov_energy_meter_f32x6_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f64x6)
template <> class EnergyMeter<Axes<double, 6>> : public detail::LyapunovBlock<lyapunov_energy_meter_f64x6> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f64x6 &sample, const lyapunov_correction_f64x6 &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f64x6_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f64 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f64>(); lyapunov_energy_meter_f64x6_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f32screw)
template <> class EnergyMeter<Screw<float>> : public detail::LyapunovBlock<lyapunov_energy_meter_f32screw> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f32screw &sample, const lyapunov_correction_f32screw &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f32screw_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f32 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f32>(); lyapunov_energy_meter_f32screw_summary(&storage, &summary); return summary; }
};

LYAPUNOV_BLOCK(lyapunov_energy_meter_f64screw)
template <> class EnergyMeter<Screw<double>> : public detail::LyapunovBlock<lyapunov_energy_meter_f64screw> {
public:
    /* Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not counted. */
    Code add(const lyapunov_sample_f64screw &sample, const lyapunov_correction_f64screw &correction) noexcept { return static_cast<Code>(lyapunov_energy_meter_f64screw_add(&storage, &sample, &correction)); }
    /* Writes the energies up to now. */
    lyapunov_energy_summary_f64 summary() const noexcept { auto summary = detail::unanswered<lyapunov_energy_summary_f64>(); lyapunov_energy_meter_f64screw_summary(&storage, &summary); return summary; }
};

#undef LYAPUNOV_BLOCK
#undef LYAPUNOV_ACCOUNT

} // namespace lyapunov

#endif

#endif
