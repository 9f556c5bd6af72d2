//! Loops that tick together, each with a memory of its own.

use lyapunov::stabilizers::Member;
use lyapunov::{Dissipation, PortEnergy, Reading, Readings as Memory, Scalar, Stabilizer as _};
use lyapunov_lab::F64x8;
use nalgebra::SVector;
use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use rayon::ThreadPool;
use rayon::prelude::*;

use super::arrays::Given;
use super::corrections::{Corrections, Scarce, Written, scarce};
use super::lanes::{LANES, Lanes, write_mask};
use crate::axes::{no_block_of, whatever_axes};
use crate::blocks::{Recipe, Stabilizer, seen, taken};
use crate::errors::{self, of_class};
use crate::lab::pool;
use crate::number;
use crate::whole;

/// Groups of loops that a thread takes at once.
const SHARE: usize = 16;

/// Stabilizer of eight loops.
type Members<V> = Member<V, (PortEnergy, Dissipation<F64x8>)>;

/// Eight loops.
#[derive(Clone, Copy, Debug)]
struct Group<V: Lanes> {
    readings: Memory<V>,
    member: Members<V>,
}

/// Groups of loops, whatever their axes.
#[derive(Clone, Debug)]
enum AnyGroups {
    One(Vec<Group<F64x8>>),
    Two(Vec<Group<SVector<F64x8, 2>>>),
    Three(Vec<Group<SVector<F64x8, 3>>>),
    Six(Vec<Group<SVector<F64x8, 6>>>),
    Seven(Vec<Group<SVector<F64x8, 7>>>),
}

/// Loops that tick together, each with readings and a stabilizer of its own, on lanes and all cores.
///
/// `Batch(stabilizer, loops, period, *, no_faster_than=None)`: as many fresh copies of `stabilizer`, which is left as it is,
/// and readings every `period` seconds. A candidate written in Python cannot be one of them.
#[pyclass(module = "lyapunov", skip_from_py_object)]
#[derive(Clone, Debug)]
pub(crate) struct Batch {
    groups: AnyGroups,
    loops: usize,
}

fn groups<V: Lanes>(
    recipe: &Recipe,
    loops: usize,
    period: f64,
    fastest: Option<f64>,
) -> PyResult<Vec<Group<V>>> {
    let readings = Memory::every(F64x8::of(period)).map_err(errors::parameter)?;
    let readings = match fastest {
        Some(fastest) => readings.no_faster_than(F64x8::of(fastest)).map_err(errors::parameter)?,
        None => readings,
    };
    let damper = || Ok((PortEnergy, Dissipation::of(F64x8::of(recipe.damping.unwrap_or(0.0)))?));
    let member = recipe.make(damper).map_err(errors::parameter)?;
    let (mut groups, count) = (Vec::new(), loops.div_ceil(LANES));
    groups.try_reserve_exact(count).map_err(|_| {
        PyMemoryError::new_err(format!(
            "loops is {loops}, for which there is no memory; give fewer, in several batches"
        ))
    })?;
    groups.resize(count, Group { readings, member });
    Ok(groups)
}

#[pymethods]
impl Batch {
    #[new]
    #[pyo3(signature = (stabilizer, loops, period, *, no_faster_than=None))]
    fn new(
        stabilizer: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole::loops)] loops: usize,
        #[pyo3(from_py_with = number::period)] period: f64,
        #[pyo3(from_py_with = number::no_faster_than_if_any)] no_faster_than: Option<f64>,
    ) -> PyResult<Self> {
        let stabilizer = seen(of_class::<Stabilizer>(stabilizer, "stabilizer")?)?;
        let recipe = &stabilizer.recipe;
        if recipe.object.is_some() {
            return Err(errors::input(
                "a candidate written in Python runs in one loop at a time\n  = call the Stabilizer of each loop, or credit a damping",
            ));
        }
        macro_rules! made {
            ($kind:ident, $signal:ty) => {
                AnyGroups::$kind(groups::<$signal>(recipe, loops, period, no_faster_than)?)
            };
        }
        let groups = match stabilizer.count() {
            1 => made!(One, F64x8),
            2 => made!(Two, SVector<F64x8, 2>),
            3 => made!(Three, SVector<F64x8, 3>),
            6 => made!(Six, SVector<F64x8, 6>),
            7 => made!(Seven, SVector<F64x8, 7>),
            axes => return Err(no_block_of(axes)),
        };
        Ok(Self { groups, loops })
    }

    /// The number of loops.
    #[getter]
    fn loops(slf: &Bound<'_, Self>) -> PyResult<usize> {
        Ok(seen(slf)?.loops)
    }

    /// The corrections of all loops.
    ///
    /// `position`, m, `applied`, N, the effort that acted since the tick before, and `effort`, N: float64 arrays of shape
    /// (loops,) on one axis and (loops, axes) on several; with a first axis of time before these, ticks one after the other.
    /// They are contiguous and not copied, and the interpreter's lock is not held. A position of NaN is a tick without a reading.
    fn stabilize<'py>(
        slf: &Bound<'py, Self>,
        position: &Bound<'py, PyAny>,
        applied: &Bound<'py, PyAny>,
        effort: &Bound<'py, PyAny>,
    ) -> PyResult<Corrections> {
        let given = [
            Given::of(position, "position")?,
            Given::of(applied, "applied")?,
            Given::of(effort, "effort")?,
        ];
        let (py, this) = (slf.py(), &mut *taken(slf)?);
        let loops = this.loops;
        whatever_axes!(&mut this.groups, AnyGroups, groups => stabilized(py, groups, loops, &given))
    }

    /// A copy with the same memory.
    fn __copy__(slf: &Bound<'_, Self>) -> PyResult<Self> {
        Ok(seen(slf)?.clone())
    }

    fn __deepcopy__(slf: &Bound<'_, Self>, _memo: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::__copy__(slf)
    }

    fn __repr__(slf: &Bound<'_, Self>) -> PyResult<String> {
        Ok(format!("Batch(loops={})", seen(slf)?.loops))
    }
}

fn stabilized<V: Lanes>(
    py: Python<'_>,
    groups: &mut [Group<V>],
    loops: usize,
    [position, applied, effort]: &[Given<'_>; 3],
) -> PyResult<Corrections> {
    let shape = position.shape().to_vec();
    let one = if V::COUNT == 1 { vec![loops] } else { vec![loops, V::COUNT] };
    let ticks = match shape.strip_suffix(&one[..]) {
        Some([]) => 1,
        Some([ticks]) => *ticks,
        _ => return Err(position.not(&format!("{one:?}, or the same with a first axis of time"))),
    };
    applied.is_like(position)?;
    effort.is_like(position)?;
    let given = [position.numbers()?, applied.numbers()?, effort.numbers()?];
    let pool = pool()?;
    let written = py.detach(|| {
        let mut written = Written::room(ticks * loops, V::COUNT)?;
        spread(&pool, groups, loops, given, &mut written)?;
        Ok(written)
    });
    let written: Written = written.map_err(|_: Scarce| scarce(ticks, loops))?;
    written.shown(py, &shape, V::COUNT)
}

/// Rows of a share of the loops, one for each tick.
struct Share<'a> {
    first: usize,
    effort: Vec<&'a mut [f64]>,
    observed_energy: Vec<&'a mut [f64]>,
    alpha: Vec<&'a mut [f64]>,
    shortfall: Vec<&'a mut [f64]>,
    accepted: Vec<&'a mut [bool]>,
}

/// Rows of `whole` numbers cut into shares of `width`: for each share, its part of every row.
fn shares<T>(numbers: &mut [T], whole: usize, width: usize) -> Result<Vec<Vec<&mut [T]>>, Scarce> {
    let mut shares: Vec<Vec<&mut [T]>> = Vec::new();
    shares.try_reserve_exact(whole.div_ceil(width))?;
    shares.resize_with(whole.div_ceil(width), Vec::new);
    for share in &mut shares {
        share.try_reserve_exact(numbers.len() / whole)?;
    }
    for row in numbers.chunks_mut(whole) {
        for (share, part) in shares.iter_mut().zip(row.chunks_mut(width)) {
            share.push(part);
        }
    }
    Ok(shares)
}

/// Ticks all loops, shares of them on each thread.
fn spread<V: Lanes>(
    pool: &ThreadPool,
    groups: &mut [Group<V>],
    loops: usize,
    given: [&[f64]; 3],
    written: &mut Written,
) -> Result<(), Scarce> {
    let width = SHARE * LANES;
    let effort = shares(&mut written.effort, loops * V::COUNT, width * V::COUNT)?;
    let rest = [&mut written.observed_energy, &mut written.alpha, &mut written.shortfall];
    let [observed_energy, alpha, shortfall] = rest.map(|numbers| shares(numbers, loops, width));
    let (observed_energy, alpha, shortfall) = (observed_energy?, alpha?, shortfall?);
    let accepted = shares(&mut written.accepted, loops, width)?;
    let parts = effort.into_iter().zip(observed_energy).zip(alpha).zip(shortfall).zip(accepted);
    let parts = parts.enumerate().map(
        |(at, ((((effort, observed_energy), alpha), shortfall), accepted))| Share {
            first: at * width,
            effort,
            observed_energy,
            alpha,
            shortfall,
            accepted,
        },
    );
    let mut shares: Vec<Share<'_>> = Vec::new();
    shares.try_reserve_exact(groups.len().div_ceil(SHARE))?;
    shares.extend(parts);
    let tick = |(groups, mut share): (&mut [Group<V>], Share<'_>)| {
        pulp::Arch::new().dispatch(Ticks { groups, share: &mut share, loops, given });
    };
    match shares.len() {
        // The pool may be busy with hours of another thread's work, which a single share need not wait for.
        1 => groups.chunks_mut(SHARE).zip(shares).for_each(tick),
        _ => pool.install(|| groups.par_chunks_mut(SHARE).zip(shares).for_each(tick)),
    }
    Ok(())
}

/// The ticks of a share, on the instructions that the processor has.
struct Ticks<'a, 'b, V: Lanes> {
    groups: &'a mut [Group<V>],
    share: &'a mut Share<'b>,
    loops: usize,
    given: [&'a [f64]; 3],
}

impl<V: Lanes> pulp::NullaryFnOnce for Ticks<'_, '_, V> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { groups, share, loops, given } = self;
        for tick in 0..share.alpha.len() {
            let row = tick * loops;
            let count = share.alpha[tick].len();
            for (at, group) in groups.iter_mut().enumerate() {
                let (first, last) = (at * LANES, count.min((at + 1) * LANES));
                let from = (row + share.first + first) * V::COUNT;
                let to = (row + share.first + last) * V::COUNT;
                let [position, applied, effort] =
                    given.map(|numbers| V::gather(&numbers[from..to], last - first));
                let sample = group.readings.read(Reading { position, applied }).sample;
                let told = group.member.stabilize(&sample, effort);
                told.effort.scatter(&mut share.effort[tick][first * V::COUNT..last * V::COUNT]);
                told.observed_energy.scatter(&mut share.observed_energy[tick][first..last]);
                told.alpha.scatter(&mut share.alpha[tick][first..last]);
                told.shortfall.scatter(&mut share.shortfall[tick][first..last]);
                write_mask(told.accepted, &mut share.accepted[tick][first..last]);
            }
        }
    }
}
