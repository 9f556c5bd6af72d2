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
// The classes, generated.

#undef LYAPUNOV_BLOCK
#undef LYAPUNOV_ACCOUNT

} // namespace lyapunov

#endif

#endif
