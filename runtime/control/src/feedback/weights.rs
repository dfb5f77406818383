//! What a regulator weighs: deviations against effort.

use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Reason, no_names};
use carvallo_design::{Failure, Place, Problem, is_called};

use crate::{Order, Output, Ports, Signal};

/// The weights of a linear quadratic regulator, which keeps the integral of `sum q y^2 + sum r u^2` as small as it can be: q of
/// outputs y, r of inputs u, each in the inverse square of its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Weights {
    /// Outputs with their weights, each not negative.
    pub outputs: Vec<(Output, f64)>,
    /// Of each input by its place, positive.
    pub inputs: Vec<(usize, f64)>,
}

impl Weights {
    /// Of texts such as `phi=10` and `Tdelta=0.1`, for some of the inputs by their places. The name of an input is that of its
    /// force; inputs that are not named have the weight 1. Where no output is named each state has the weight 1, else those that
    /// are not named have none.
    ///
    /// # Errors
    /// Everything that is wrong with them.
    pub fn read(texts: &[String], ports: &Ports, inputs: &[usize]) -> Result<Self, Failure> {
        let mut weights = Self { outputs: Vec::new(), inputs: inputs.iter().map(|&input| (input, 1.0)).collect() };
        let (mut given, mut problems) = (Vec::new(), Vec::new());
        for text in texts {
            if let Err(message) = weights.take(text, ports, &mut given) {
                problems.push(Problem { place: Place::Option(format!("--weight {text}")), message });
            }
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        if weights.outputs.is_empty() {
            weights.outputs = ports.states().into_iter().map(|state| (state, 1.0)).collect();
        }
        Ok(weights)
    }

    fn take(&mut self, text: &str, ports: &Ports, given: &mut Vec<usize>) -> Result<(), String> {
        let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE, such as phi=10 or Tdelta=0.1")?;
        let context = Context { unit: "1", names: &no_names };
        let value = quantity::number(value, context);
        let value = value.map_err(|mistake| {
            let text = text[name.len() + 1..].trim();
            match mistake.reason {
                Reason::Unit(_) => format!(
                    "`{text}` must have no unit behind it: a weight is in the inverse square of the unit of `{}` in the SI",
                    name.trim()
                ),
                Reason::Other(_) => format!("`{text}` must be a finite number"),
            }
        })?;
        let name = name.trim();
        let is_own =
            |input: &Signal| input.name.eq_ignore_ascii_case(name) || is_called(&input.name, &input.label, name);
        let own = ports.inputs.iter().position(is_own);
        if let Some(input) = own {
            let name = &ports.inputs[input].name;
            let place = self.inputs.iter().position(|(other, _)| *other == input);
            let place = place.ok_or_else(|| format!("`{name}` is not among the inputs"))?;
            if given.contains(&input) {
                return Err(format!("`{name}` has a weight already"));
            }
            if value <= 0.0 {
                return Err(format!("the weight of an input is {}; it must be > 0", shortest(value)));
            }
            given.push(input);
            self.inputs[place].1 = value;
            return Ok(());
        }
        let output = ports.output(name)?;
        let name = ports.signal(output).name;
        if output.order == Order::Acceleration {
            return Err(format!("`{name}` follows the inputs at once; expected a position or a rate"));
        }
        if self.outputs.iter().any(|(other, _)| *other == output) {
            return Err(format!("`{name}` has a weight already"));
        }
        if value < 0.0 {
            return Err(format!("the weight of an output is {}; it must be >= 0", shortest(value)));
        }
        self.outputs.push((output, value));
        Ok(())
    }
}
