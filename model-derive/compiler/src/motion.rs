//! The motion of a mechanism whose nonlinear equations are asked for: what is free, and what it is called.

use crate::nonlinear::{Layout, Machine};

/// What the equations are derived from, and the names of what they are in.
#[derive(Debug)]
pub struct MotionModel {
    /// The mechanism with what is proved of it.
    pub machine: Machine,
    /// Which of its joints are free.
    pub layout: Layout,
    /// In the order of the layout.
    pub positions: Vec<Position>,
    /// The names of the wheels, each with what it is.
    pub wheels: Vec<[String; 2]>,
    /// The same machine with its attributes as further parameters, behind all others: for mistakes in one of them.
    pub by_attributes: Option<Machine>,
}

impl MotionModel {
    /// For each speed the place of the position whose rate it is.
    pub fn speeds(&self) -> Vec<usize> {
        self.places(&self.layout.conditions.independent)
    }

    /// The places of the positions that the heights of the wheels determine.
    pub fn dependent(&self) -> Vec<usize> {
        self.places(&self.layout.standing)
    }

    fn places(&self, joints: &[usize]) -> Vec<usize> {
        let place = |joint: &usize| self.layout.positions.iter().position(|position| position == joint);
        joints.iter().filter_map(place).collect()
    }
}

/// A position of a joint.
#[derive(Debug)]
pub struct Position {
    /// That of the coordinate, or as the paper has it.
    pub name: String,
    /// What it is.
    pub label: String,
    /// `rad` or `m`.
    pub unit: &'static str,
    /// What the equations have to do with it.
    pub kind: PositionKind,
}

/// What the equations have to do with a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PositionKind {
    /// It is free to choose, and the motion depends on it.
    Free,
    /// The heights of the wheels determine it.
    Dependent,
    /// The motion does not depend on it.
    Ignorable,
}
