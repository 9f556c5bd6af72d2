//! Edge between the sides of a grid, found by halving blocks of cells.
//!
//! The grid is divided into blocks that share their borders. A block whose judged cells lie on different sides is halved
//! along each axis, until the edge passes between neighbouring cells. Of a block whose judged cells agree, nothing else is
//! judged: an island that no judged cell meets stays unseen.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::side::Side;

/// The number of blocks along an axis at the start, between this and its double where there are as many cells.
const BLOCKS: u64 = 128;

/// The cells along a block of the start, where there are fewer than that number of blocks.
const SMALL: u64 = 8;

/// One over the share of the cells that may be judged.
const SHARE: u64 = 20;

/// The number of cells that may be judged in any case.
const LEAST: u64 = 1 << 14;

/// A block of cells: from its lower corner to the next one of its level, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct Block {
    /// How often the blocks of the start have been halved.
    level: u32,
    at: [u64; 2],
}

/// The judged cells of a grid, and its division into blocks.
#[derive(Clone, Debug)]
pub struct Edge {
    columns: u64,
    /// The indices of the last column and row.
    last: [u64; 2],
    /// The cells along both sides of a block of the start.
    coarsest: [u64; 2],
    judged: HashMap<u64, Side>,
    /// Blocks whose judged cells agree.
    uniform: HashMap<Block, Side>,
    /// Blocks of neighbouring cells that do not.
    mixed: BTreeSet<Block>,
    /// Larger blocks that do not, and were not halved for want of runs.
    unresolved: BTreeSet<Block>,
}

/// Shares of a grid's area.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shares {
    /// Share on each side, in the order of [`Side::ALL`]; a block that the edge passes counts by its corners.
    pub sides: [f64; Side::ALL.len()],
    /// Share of the blocks that the edge passes: the sides are known to within half of it, but for unseen islands.
    pub passed: f64,
}

impl Edge {
    /// The edge on a grid of `columns` by `rows` cells, both at least 1; `judge` tells the sides of cells.
    ///
    /// # Errors
    /// Those of `judge`.
    pub(super) fn find<E>(
        [columns, rows]: [u64; 2],
        mut judge: impl FnMut(&[u64]) -> Result<Vec<Side>, E>,
    ) -> Result<Self, E> {
        let coarsest = [columns, rows].map(|count| {
            let size = (count / BLOCKS).max((count / SMALL).clamp(1, SMALL));
            1 << size.ilog2()
        });
        let mut edge = Self {
            columns,
            last: [columns - 1, rows - 1],
            coarsest,
            judged: HashMap::new(),
            uniform: HashMap::new(),
            mixed: BTreeSet::new(),
            unresolved: BTreeSet::new(),
        };
        let most = (columns * rows / SHARE).max(LEAST) as usize;
        let blocks = edge.blocks();
        let corners: BTreeSet<u64> = blocks.iter().flat_map(|block| edge.corners(*block)).collect();
        let mut waiting = BTreeMap::new();
        edge.judge(corners, &mut judge)?;
        blocks.into_iter().for_each(|block| edge.place(block, &mut waiting));
        // Coarse blocks come first: what the budget leaves open is told at the finest scale that it allows everywhere.
        while let Some((level, blocks)) = waiting.pop_first() {
            if level == edge.finest() {
                edge.mixed.extend(blocks);
                continue;
            }
            let halved = edge.affordable(blocks, most);
            let points = halved.iter().flat_map(|block| edge.halves(*block).1).collect();
            let points = edge.judge(points, &mut judge)?;
            for block in &halved {
                let (children, _) = edge.halves(*block);
                children.into_iter().for_each(|child| edge.place(child, &mut waiting));
            }
            points.into_iter().for_each(|cell| edge.compare(cell, &mut waiting));
        }
        Ok(edge)
    }

    /// The blocks of the start.
    fn blocks(&self) -> Vec<Block> {
        let [x, y] =
            [0, 1].map(|axis| (0..self.last[axis].max(1)).step_by(self.coarsest[axis] as usize));
        y.flat_map(|y| x.clone().map(move |x| Block { level: 0, at: [x, y] })).collect()
    }

    fn size(&self, level: u32) -> [u64; 2] {
        self.coarsest.map(|size| (size >> level).max(1))
    }

    /// The level at which the corners of a block are neighbours.
    fn finest(&self) -> u32 {
        self.coarsest.map(u64::ilog2).into_iter().max().unwrap_or(0)
    }

    /// The upper corner of a block.
    fn upper(&self, block: Block) -> [u64; 2] {
        let size = self.size(block.level);
        [0, 1].map(|axis| (block.at[axis] + size[axis]).min(self.last[axis]))
    }

    fn cell(&self, [x, y]: [u64; 2]) -> u64 {
        x + y * self.columns
    }

    fn corners(&self, block: Block) -> [u64; 4] {
        let ([x, y], [right, top]) = (block.at, self.upper(block));
        [[x, y], [right, y], [x, top], [right, top]].map(|at| self.cell(at))
    }

    /// The blocks into which a block is halved, and their corners.
    fn halves(&self, block: Block) -> (Vec<Block>, Vec<u64>) {
        let (level, upper) = (block.level + 1, self.upper(block));
        let size = self.size(level);
        let [x, y] = [0, 1].map(|axis| {
            let middle = block.at[axis] + size[axis];
            std::iter::once(block.at[axis]).chain((middle < upper[axis]).then_some(middle))
        });
        let children: Vec<Block> =
            y.flat_map(|y| x.clone().map(move |x| Block { level, at: [x, y] })).collect();
        let corners = children.iter().flat_map(|child| self.corners(*child)).collect();
        (children, corners)
    }

    /// Judges those of `cells` that are not judged yet, and returns them.
    fn judge<E>(
        &mut self,
        cells: BTreeSet<u64>,
        judge: &mut impl FnMut(&[u64]) -> Result<Vec<Side>, E>,
    ) -> Result<Vec<u64>, E> {
        let mut cells: Vec<u64> = cells.into_iter().collect();
        cells.retain(|cell| !self.judged.contains_key(cell));
        let sides = judge(&cells)?;
        self.judged.extend(cells.iter().copied().zip(sides));
        Ok(cells)
    }

    /// Enters a block whose corners are judged, among the uniform ones or those that wait to be halved.
    fn place(&mut self, block: Block, waiting: &mut BTreeMap<u32, BTreeSet<Block>>) {
        let ([x, y], [right, top]) = (block.at, self.upper(block));
        let level = (x..=right).flat_map(|x| [[x, y], [x, top]]);
        let upright = (y..=top).flat_map(|y| [[x, y], [right, y]]);
        // A finer neighbour may have judged cells on the border.
        let border = level.chain(upright).filter_map(|at| self.judged.get(&self.cell(at)));
        let mut sides = border.copied();
        match sides.next().filter(|first| sides.all(|side| side == *first)) {
            Some(side) => drop(self.uniform.insert(block, side)),
            None => drop(waiting.entry(block.level).or_default().insert(block)),
        }
    }

    /// Lets the uniform blocks wait to be halved on whose border `cell` lies, if it is on another side.
    fn compare(&mut self, cell: u64, waiting: &mut BTreeMap<u32, BTreeSet<Block>>) {
        let Some(&side) = self.judged.get(&cell) else { return };
        for block in self.around(cell) {
            if self.uniform.get(&block).is_some_and(|other| *other != side) {
                self.uniform.remove(&block);
                waiting.entry(block.level).or_default().insert(block);
            }
        }
    }

    /// The blocks of all levels that hold `cell`.
    fn around(&self, cell: u64) -> Vec<Block> {
        let at = [cell % self.columns, cell / self.columns];
        let lower = |axis: usize, size: u64| {
            let here = at[axis] / size * size;
            let before = (here == at[axis]).then(|| here.checked_sub(size)).flatten();
            std::iter::once(here).chain(before)
        };
        let levels = 0..=self.finest();
        let of = |level| {
            let [width, height] = self.size(level);
            lower(1, height)
                .flat_map(move |y| lower(0, width).map(move |x| Block { level, at: [x, y] }))
        };
        levels.flat_map(of).collect()
    }

    /// Those of `blocks`, all of one level, whose halving keeps the judged cells below `most`; the others are unresolved.
    fn affordable(&mut self, blocks: BTreeSet<Block>, most: usize) -> BTreeSet<Block> {
        let cost = |edge: &Self, blocks: &BTreeSet<Block>| {
            let points: BTreeSet<u64> =
                blocks.iter().flat_map(|block| edge.halves(*block).1).collect();
            points.iter().filter(|cell| !edge.judged.contains_key(cell)).count()
        };
        if self.judged.len() + cost(self, &blocks) <= most {
            return blocks;
        }
        let ragged = self.ragged_among(&blocks);
        let (open, smooth): (BTreeSet<_>, BTreeSet<_>) =
            blocks.into_iter().partition(|block| ragged.contains(&self.start_of(*block)));
        self.unresolved.extend(open);
        if self.judged.len() + cost(self, &smooth) <= most {
            return smooth;
        }
        self.unresolved.extend(smooth);
        BTreeSet::new()
    }

    /// The block of the start that a block is part of.
    fn start_of(&self, block: Block) -> [u64; 2] {
        [0, 1].map(|axis| block.at[axis] / self.coarsest[axis] * self.coarsest[axis])
    }

    /// The blocks of the start with more of `blocks`, all of one level, than an edge passes that only rises or only falls.
    fn ragged_among(&self, blocks: &BTreeSet<Block>) -> BTreeSet<[u64; 2]> {
        let mut passed: BTreeMap<[u64; 2], u64> = BTreeMap::new();
        for block in blocks {
            *passed.entry(self.start_of(*block)).or_default() += 1;
        }
        let Some(first) = blocks.first() else { return BTreeSet::new() };
        let size = self.size(first.level);
        let most = (0..2).map(|axis| self.coarsest[axis] / size[axis]).sum::<u64>() - 1;
        passed.into_iter().filter(|(_, count)| *count > most).map(|(start, _)| start).collect()
    }

    /// The lower corners of the blocks of the start in which the edge is ragged: it passes more neighbouring cells than
    /// an edge can that only rises or only falls, or was not resolved.
    pub(super) fn ragged(&self) -> BTreeSet<[u64; 2]> {
        let mut ragged = self.ragged_among(&self.mixed);
        ragged.extend(self.unresolved.iter().map(|block| self.start_of(*block)));
        ragged
    }

    /// The number of blocks of the start that hold a part of the edge.
    pub fn passed_blocks(&self) -> usize {
        let passed = self.mixed.iter().chain(&self.unresolved);
        passed.map(|block| self.start_of(*block)).collect::<BTreeSet<_>>().len()
    }

    /// The number of blocks of the start in which the edge is ragged.
    pub fn ragged_blocks(&self) -> usize {
        self.ragged().len()
    }

    /// The cells along both sides of a block of the start.
    pub fn coarsest(&self) -> [u64; 2] {
        self.coarsest
    }

    /// The cells along both sides of the largest block that was not resolved; none where the edge is known to the cell.
    pub fn unresolved(&self) -> Option<[u64; 2]> {
        self.unresolved.first().map(|block| self.size(block.level))
    }

    /// The judged cells in their order.
    pub fn judged(&self) -> Vec<(u64, Side)> {
        let mut judged: Vec<_> = self.judged.iter().map(|(cell, side)| (*cell, *side)).collect();
        judged.sort_unstable();
        judged
    }

    /// The side of a cell: judged, or that of the block around it; of an unresolved block that of its lower corner.
    pub fn side(&self, cell: u64) -> Side {
        if let Some(side) = self.judged.get(&cell) {
            return *side;
        }
        let around = self.around(cell);
        let uniform = around.iter().find_map(|block| self.uniform.get(block));
        let open = || around.iter().find(|block| self.unresolved.contains(block));
        let corner = || open().and_then(|block| self.judged.get(&self.cell(block.at)));
        // Every cell lies in some block, and in one of the finest it is judged.
        *uniform.or_else(corner).unwrap_or(&Side::TooShort)
    }

    /// The shares of the area between the first and the last values of both axes.
    pub fn shares(&self) -> Shares {
        let area = |block: Block| {
            let upper = self.upper(block);
            let extent = |axis: usize| (upper[axis] - block.at[axis]).max(1) as f64;
            extent(0) * extent(1)
        };
        let whole: f64 = self.last.iter().map(|last| (*last).max(1) as f64).product();
        let mut shares = Shares::default();
        let passed = self.mixed.iter().chain(&self.unresolved);
        let quarters = passed.clone().flat_map(|block| {
            self.corners(*block).map(|cell| (self.judged[&cell], 0.25 * area(*block)))
        });
        let uniform = self.uniform.iter().map(|(block, side)| (*side, area(*block)));
        for (side, area) in quarters.chain(uniform) {
            // Areas are whole quarters of cells: their sum does not depend on the order.
            shares.sides[side as usize] += area;
        }
        shares.sides = shares.sides.map(|area| area / whole);
        shares.passed = passed.fold(0.0, |sum, block| sum + area(*block)) / whole;
        shares
    }
}
