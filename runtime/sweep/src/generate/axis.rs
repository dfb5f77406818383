//! A parameter that takes one value after the other: `w=0.9:1.2:0.01`, `w=0.9:1.2:31 points`, `mB=60,75,90`.

use carvallo::ParameterInfo;
use carvallo_design::conventions::{Naming, Varying};
use carvallo_design::input::evaluated;
use carvallo_design::number::with_unit;
use carvallo_design::parameter::{any_possible, check_units, number, too_wide};
use carvallo_design::quantity::{Steps, check_commas};

/// More than this many values of one parameter are taken for a slip in the step.
const MAX_POINTS: f64 = 1_000_000.0;

/// A parameter and the values that it takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    pub parameter: Varying,
    pub values: Vec<f64>,
}

impl Axis {
    /// # Errors
    /// What is wrong. Some values outside of the parameter's domain are not: they are designs without a result.
    pub fn parse(text: &str, naming: &Naming) -> Result<Self, String> {
        let expected = "expected NAME=LOW:HIGH:STEP, NAME=LOW:HIGH:N points or NAME=a,b,c, such as w=0.9:1.2:0.01";
        let (name, values) = text.split_once('=').ok_or(expected)?;
        let varying = naming.find(name.trim())?;
        let parameter = &varying.info;
        let values = match values.split(':').collect::<Vec<_>>()[..] {
            [list] => {
                let list = list.split(',').collect::<Vec<&str>>();
                let list = list.iter().map(|text| varying.in_numbers(text, naming)).collect::<Result<Vec<_>, _>>()?;
                let list: Vec<&str> = list.iter().map(AsRef::as_ref).collect();
                let values = list.iter().map(|value| number(value, parameter)).collect::<Result<Vec<f64>, _>>()?;
                check_commas(&list)?;
                check_units(&list, parameter)?;
                values
            }
            [low, high, last] => {
                let (low, high) = (varying.in_numbers(low, naming)?, varying.in_numbers(high, naming)?);
                let (low, high) = (low.as_ref(), high.as_ref());
                let range = Range::parse(low, high, parameter)?;
                match last.trim_end().strip_suffix("points").or_else(|| last.trim_end().strip_suffix("point")) {
                    Some(count) => check_units(&[low, high], parameter).and_then(|()| range.points(count))?,
                    None => {
                        let values = range.steps(low, last, parameter)?;
                        check_units(&[low, high, last], parameter)?;
                        values
                    }
                }
            }
            _ => return Err(expected.to_owned()),
        };
        any_possible(&values, parameter)?;
        Ok(Self { parameter: varying, values })
    }
}

struct Range {
    low: f64,
    high: f64,
}

impl Range {
    fn parse(low: &str, high: &str, info: &ParameterInfo) -> Result<Self, String> {
        let (low, high) = (number(low, info)?, number(high, info)?);
        if low > high {
            let [low, high] = [low, high].map(|value| with_unit(value, info.unit));
            return Err(format!("the range ends at {high}, before it begins at {low}; it must ascend"));
        }
        if !(high - low).is_finite() {
            return Err(too_wide(low, high, info));
        }
        Ok(Self { low, high })
    }

    fn points(&self, count: &str) -> Result<Vec<f64>, String> {
        let Self { low, high } = *self;
        let count = count.trim();
        match count.parse::<u32>() {
            Ok(count) if count >= 2 && f64::from(count) <= MAX_POINTS => {
                let share = |index: u32| f64::from(index) / f64::from(count - 1);
                let at = |index: u32| low + (high - low) * share(index);
                // The end as it was written, free of rounding.
                Ok((0..count - 1).map(at).chain([high]).collect())
            }
            _ => Err(format!("the number of points is `{count}`; it must be a whole number from 2 to {MAX_POINTS}")),
        }
    }

    fn steps(&self, low: &str, step: &str, info: &ParameterInfo) -> Result<Vec<f64>, String> {
        let written = Steps::new(low, step);
        let step_text = step.trim();
        let step = evaluated(step, info).map_err(|found| format!("the step of `{}` is {found}", info.name))?;
        if step <= 0.0 {
            return Err(format!("the step is `{step_text}`; it must be > 0"));
        }
        if step > self.high - self.low && self.high > self.low {
            let step = with_unit(step, info.unit);
            return Err(format!(
                "the step is {step}, longer than the range; a number of values is `{step_text} points`"
            ));
        }
        // The end belongs to the range also if the division falls just short of it.
        let steps = ((self.high - self.low) / step + 1e-9).floor();
        if steps >= MAX_POINTS {
            return Err(format!("the range has more than {MAX_POINTS} points"));
        }
        let at = |index: u32| {
            let written = written.as_ref().and_then(|steps| steps.text(index));
            let value = written.and_then(|text| evaluated(&text, info).ok());
            value.unwrap_or(self.low + f64::from(index) * step) + 0.0
        };
        Ok((0..=steps as u32).map(at).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::Axis;
    use carvallo_design::WHIPPLE;
    use carvallo_design::conventions::Naming;

    fn parsed(text: &str) -> Result<Axis, String> {
        Axis::parse(text, &Naming::new(WHIPPLE.info, text.split('=').next()))
    }

    fn values(text: &str) -> Vec<f64> {
        parsed(text).map(|axis| axis.values).unwrap_or_default()
    }

    #[test]
    fn ranges_have_the_values_that_one_would_write() {
        assert_eq!(values("w=0.9:1.2:0.1"), [0.9, 1.0, 1.1, 1.2]);
        assert_eq!(values("c=-0.1:0.1:0.1"), [-0.1, 0.0, 0.1]);
        assert!(values("c=-0.1:0.1:0.1")[1].is_sign_positive());
        let degrees = |degrees: f64| degrees * std::f64::consts::PI / 180.0;
        assert_eq!(values("lam=17 deg:19deg:1 deg"), [17.0, 18.0, 19.0].map(degrees));
        assert_eq!(values("w=1:2:5 points"), [1.0, 1.25, 1.5, 1.75, 2.0]);
        assert_eq!(values("w=1:2:2points"), [1.0, 2.0]);
        assert_eq!(values("w=1,3/2, 2"), [1.0, 1.5, 2.0]);
        assert_eq!(values("mB=85"), [85.0]);
        assert_eq!(values("lam=0:pi/2:pi/4"), [0.0, std::f64::consts::FRAC_PI_4, std::f64::consts::FRAC_PI_2]);
    }

    #[test]
    fn mistakes_are_named() {
        for (text, message) in [
            ("w", "expected NAME=LOW:HIGH:STEP, NAME=LOW:HIGH:N points or NAME=a,b,c, such as w=0.9:1.2:0.01"),
            ("ww=1,2", "`ww` is not a parameter of Whipple; did you mean `w`?"),
            ("I_Rzz=1,2", "`I_Rzz` is not a parameter of Whipple: wheels are axisymmetric, so it equals `IRxx`"),
            ("yB=0,1", "`yB` is not a parameter of Whipple: the bicycle is laterally symmetric"),
            ("kphi=0,1", "`kphi` is not a parameter of Whipple: the bicycle has no control"),
            ("v=0:10:1", "`v` is not a parameter of Whipple; --eigenvalues takes speeds"),
            ("mb=1,2", "`mb` is not a parameter of Whipple; did you mean `mB`?"),
            ("w=1:2:0", "the step is `0`; it must be > 0"),
            ("w=2:1:0.1", "the range ends at 1 m, before it begins at 2 m; it must ascend"),
            ("w=1:2:1 points", "the number of points is `1`; it must be a whole number from 2 to 1000000"),
            ("w=1:2:1e-9", "the range has more than 1000000 points"),
            ("w=-1e308:1e308:3 points", "the range from -1e308 m to 1e308 m is too wide for double precision"),
            ("w=1,,2", "a value of `w` is empty; expected a number, or an expression such as `pi/10`"),
            ("w=-2:-1:0.5", "no value of `w` is possible, such as -2 m; it must be > 0"),
            (
                "lam=10:30:1",
                "no value of `lam` is possible, such as 10 rad; it must be > -1.5707963267948966 and < \
                 1.5707963267948966 (for degrees write `10 deg`)",
            ),
            ("w=1 kg", "a value of `w` is `1 kg`; `kg` is no unit for it: `w` is in m"),
            ("lam=0:1:0.1 deg", "`1` has no unit, but others have: write it behind each"),
            ("lam=0.1, 5 deg", "`0.1` has no unit, but others have: write it behind each"),
            (
                "mB=85+-5",
                "a value of `mB` is `85+-5`; expected a number, or an expression such as `pi/10`: a standard deviation \
                 has no place here",
            ),
        ] {
            assert_eq!(parsed(text), Err(message.to_owned()), "{text}");
        }
    }
}
