//! Arithmetic that is written down as a program.
//!
//! Equal operations are one value, and what zero and one make of an operation is seen at once: so a general formula
//! leaves only what a mechanism has, such as nothing of the components across a plane of symmetry. Whatever else is to be
//! simplified, the passes over programs do.

use std::cell::RefCell;
use std::convert::Infallible;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};
use crate::program::passes::Builder;
use crate::program::{Instruction, Program, Value};

/// A program in the making.
pub struct Arithmetic {
    builder: RefCell<Builder>,
}

/// A value of that program.
#[derive(Clone, Copy)]
pub struct Quantity<'a> {
    arithmetic: &'a Arithmetic,
    pub value: Value,
}

impl Arithmetic {
    pub fn new(inputs: usize) -> Self {
        Self { builder: RefCell::new(Builder::new(inputs)) }
    }

    fn push(&self, instruction: Instruction) -> Quantity<'_> {
        Quantity { arithmetic: self, value: self.builder.borrow_mut().push(instruction) }
    }

    pub fn input(&self, index: usize) -> Quantity<'_> {
        self.push(Instruction::Parameter(index))
    }

    pub fn number(&self, value: f64) -> Quantity<'_> {
        // Of zero there is one.
        self.push(Instruction::Constant(if value == 0.0 { 0.0 } else { value }))
    }

    /// A value that is there already.
    pub fn at(&self, value: Value) -> Quantity<'_> {
        Quantity { arithmetic: self, value }
    }

    /// The value of a formula, with those of its definitions.
    pub fn formula<'a>(&'a self, formula: &Formula, definitions: &[Quantity<'a>]) -> Quantity<'a> {
        let Ok(value) = formula.fold(&Formulas { arithmetic: self, definitions });
        value
    }

    /// The program that computes some values.
    pub fn program(&self, outputs: &[Value]) -> Program {
        let mut program = self.builder.borrow().program().clone();
        program.outputs = outputs.to_vec();
        program
    }
}

impl<'a> Quantity<'a> {
    /// What computes it.
    pub fn instruction(self) -> Instruction {
        self.arithmetic.builder.borrow().instruction(self.value)
    }

    fn constant(self) -> Option<f64> {
        if let Instruction::Constant(value) = self.instruction() { Some(value) } else { None }
    }

    /// Whether it is zero as it stands.
    pub fn is_zero(self) -> bool {
        self.constant() == Some(0.0)
    }

    /// Whether it is one as it stands.
    pub fn is_one(self) -> bool {
        self.constant() == Some(1.0)
    }

    /// Another number beside this quantity.
    pub fn number(self, value: f64) -> Self {
        self.arithmetic.number(value)
    }

    /// A value of the same program.
    pub fn beside(self, value: Value) -> Self {
        Self { value, ..self }
    }

    pub fn square(self) -> Self {
        self * self
    }

    /// A whole power.
    pub fn power(self, exponent: i32) -> Self {
        match exponent {
            0 => self.number(1.0),
            1 => self,
            2 => self.square(),
            _ => self.arithmetic.push(Instruction::Power(self.value, exponent)),
        }
    }

    pub fn recip(self) -> Self {
        if self.is_one() { self } else { self.arithmetic.push(Instruction::Reciprocal(self.value)) }
    }

    pub fn sqrt(self) -> Self {
        if self.is_zero() || self.is_one() { self } else { self.arithmetic.push(Instruction::Sqrt(self.value)) }
    }

    pub fn sin(self) -> Self {
        self.arithmetic.push(Instruction::Sin(self.value))
    }

    pub fn cos(self) -> Self {
        self.arithmetic.push(Instruction::Cos(self.value))
    }

    pub fn tan(self) -> Self {
        self.arithmetic.push(Instruction::Tan(self.value))
    }

    /// What it is the negative of, if it is one as it stands.
    fn opposite(self) -> Option<Self> {
        match self.instruction() {
            Instruction::Neg(value) => Some(self.beside(value)),
            _ => None,
        }
    }
}

impl Neg for Quantity<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        if let Some(value) = self.constant() {
            return self.number(-value);
        }
        self.opposite().unwrap_or_else(|| self.arithmetic.push(Instruction::Neg(self.value)))
    }
}

impl Add for Quantity<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        match (self.constant(), other.constant()) {
            (Some(0.0), _) => other,
            (_, Some(0.0)) => self,
            (Some(a), Some(b)) => self.number(a + b),
            _ => match (self.opposite(), other.opposite()) {
                (Some(a), Some(b)) => -(a + b),
                (Some(a), None) => other - a,
                (None, Some(b)) => self - b,
                (None, None) => self.arithmetic.push(Instruction::Add(self.value, other.value)),
            },
        }
    }
}

impl Sub for Quantity<'_> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        if self.value == other.value {
            return self.number(0.0);
        }
        match (self.constant(), other.constant()) {
            (Some(0.0), _) => -other,
            (_, Some(0.0)) => self,
            (Some(a), Some(b)) => self.number(a - b),
            _ => match (self.opposite(), other.opposite()) {
                (Some(a), Some(b)) => b - a,
                (Some(a), None) => -(a + other),
                (None, Some(b)) => self + b,
                (None, None) => self.arithmetic.push(Instruction::Sub(self.value, other.value)),
            },
        }
    }
}

impl Mul for Quantity<'_> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        match (self.constant(), other.constant()) {
            (Some(0.0), _) | (_, Some(0.0)) => self.number(0.0),
            (Some(1.0), _) => other,
            (_, Some(1.0)) => self,
            (Some(-1.0), _) => -other,
            (_, Some(-1.0)) => -self,
            (Some(a), Some(b)) => self.number(a * b),
            _ => match (self.opposite(), other.opposite()) {
                (Some(a), Some(b)) => a * b,
                (Some(a), None) => -(a * other),
                (None, Some(b)) => -(self * b),
                (None, None) => self.arithmetic.push(Instruction::Mul(self.value, other.value)),
            },
        }
    }
}

impl Div for Quantity<'_> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if self.is_zero() || other.is_one() {
            return self;
        }
        if self.value == other.value {
            return self.number(1.0);
        }
        match (self.opposite(), other.opposite()) {
            (Some(a), Some(b)) => a / b,
            (Some(a), None) => -(a / other),
            (None, Some(b)) => -(self / b),
            (None, None) => self.arithmetic.push(Instruction::Div(self.value, other.value)),
        }
    }
}

impl fmt::Debug for Quantity<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {:?}", self.value, self.instruction())
    }
}

struct Formulas<'a, 'd> {
    arithmetic: &'a Arithmetic,
    definitions: &'d [Quantity<'a>],
}

impl<'a> Algebra for Formulas<'a, '_> {
    type Value = Quantity<'a>;
    type Error = Infallible;

    fn number(&self, number: &Decimal) -> Result<Quantity<'a>, Infallible> {
        Ok(self.arithmetic.number(number.to_f64()))
    }

    fn pi(&self) -> Quantity<'a> {
        self.arithmetic.number(std::f64::consts::PI)
    }

    fn parameter(&self, index: usize) -> Quantity<'a> {
        self.arithmetic.input(index)
    }

    fn definition(&self, index: usize) -> Quantity<'a> {
        self.definitions[index]
    }

    fn sum(&self, terms: impl Values<Term<Quantity<'a>>, Infallible>) -> Result<Quantity<'a>, Infallible> {
        Ok(terms.fold(
            self.arithmetic.number(0.0),
            |sum, Ok(Term { negative, value })| {
                if negative { sum - value } else { sum + value }
            },
        ))
    }

    fn product(&self, factors: impl Values<Factor<Quantity<'a>>, Infallible>) -> Result<Quantity<'a>, Infallible> {
        Ok(factors.fold(
            self.arithmetic.number(1.0),
            |product, Ok(Factor { inverse, value })| {
                if inverse { product / value } else { product * value }
            },
        ))
    }

    fn power(&self, base: Quantity<'a>, exponent: i32) -> Result<Quantity<'a>, Infallible> {
        Ok(base.power(exponent))
    }

    fn call(&self, function: Function, argument: Quantity<'a>) -> Result<Quantity<'a>, Infallible> {
        Ok(match function {
            Function::Sin => argument.sin(),
            Function::Cos => argument.cos(),
            Function::Tan => argument.tan(),
            Function::Sqrt => argument.sqrt(),
        })
    }
}
