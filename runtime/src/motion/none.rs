//! The motion of models that have none.

use core::convert::Infallible;
use core::marker::PhantomData;

use super::info::MotionInfo;
use super::traits::{Motion, Unchecked};
use crate::number::Scalar;

/// The motion of a model without nonlinear equations. There is no value of it.
#[derive(Clone, Copy, Debug)]
pub struct NoMotion<T> {
    none: Infallible,
    scalar: PhantomData<T>,
}

impl<T: Scalar> Motion for NoMotion<T> {
    const INFO: &'static MotionInfo =
        &MotionInfo { model: "", positions: &[], speeds: &[], dependent: &[], forces: &[], wheels: &[] };
}

impl<T: Scalar> Unchecked for NoMotion<T> {
    type Scalar = T;
    type Positions = [T; 0];
    type Speeds = [T; 0];
    type Dependent = [T; 0];
    type Forces = [T; 0];
    type ContactForces = [[T; 3]; 0];

    fn closure_unchecked(&self, _: &[T; 0]) -> ([T; 0], [T; 0]) {
        match self.none {}
    }

    fn rates_unchecked(&self, _: &[T; 0], _: &[T; 0]) -> [T; 0] {
        match self.none {}
    }

    fn derivatives_unchecked(&self, _: &[T; 0], _: &[T; 0], _: &[T; 0]) -> ([T; 0], [T; 0]) {
        match self.none {}
    }

    fn accelerations_unchecked(&self, _: &[T; 0], _: &[T; 0], _: &[T; 0]) -> [T; 0] {
        match self.none {}
    }

    fn energy_unchecked(&self, _: &[T; 0], _: &[T; 0]) -> [T; 2] {
        match self.none {}
    }

    fn contact_forces_unchecked(&self, _: &[T; 0], _: &[T; 0], _: &[T; 0]) -> [[T; 3]; 0] {
        match self.none {}
    }
}
