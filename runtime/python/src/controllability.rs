//! Which modes of one design inputs excite and outputs show, along the speed.

use carvallo::Complex;
use carvallo_control::{ModalMeasures, Ports, Signal};
use carvallo_design::Failure;
use carvallo_plot::analysis::controllability::{AtSpeed, Controllability, LostTo, drawn};
use carvallo_plot::analysis::{Analysis, reach};
use carvallo_plot::picture::draw_controllability;
use numpy::{Element, PyArray1, PyArrayMethods as _};
use pyo3::prelude::*;

use crate::designs::{Array, Designs};
use crate::loaded::raise;
use crate::one::{About, Described};
use crate::ports::ports;

/// Inputs and outputs by their names; without names all forces, and the coordinates.
#[derive(FromPyObject)]
pub struct Asked {
    /// In m/s; without any as far as there is something to see.
    #[pyo3(item)]
    speeds: Option<Vec<f64>>,
    #[pyo3(item)]
    inputs: Option<Vec<String>>,
    #[pyo3(item)]
    outputs: Option<Vec<String>>,
}

/// Everything, before it is told.
struct Found {
    of: Controllability,
    speeds: Vec<f64>,
    rows: Vec<AtSpeed>,
    lost: Vec<LostTo>,
}

/// What each mode is called, its measures, and where modes are lost: lists over the speeds and in them over the modes.
struct Measures {
    /// In m/s; none where nothing depends on them.
    speeds: Option<Vec<f64>>,
    inputs: Vec<String>,
    outputs: Vec<String>,
    modes: Vec<(String, ModalMeasures)>,
    lost: Vec<Lost>,
    shape: [usize; 2],
}

/// The name of an input or an output, whether it is an input, the speed, and the eigenvalue.
type Lost = (String, bool, f64, Complex<f64>);

/// The measures as arrays that run over the speeds, the modes, and the inputs or outputs.
#[derive(IntoPyObject)]
pub struct Told<'py> {
    speeds: Option<Vec<f64>>,
    inputs: Vec<String>,
    outputs: Vec<String>,
    /// What each mode is called, one after the other.
    modes: Vec<String>,
    eigenvalues: Array<'py, Complex<f64>>,
    controllability: Array<'py, f64>,
    observability: Array<'py, f64>,
    excitation: Array<'py, Complex<f64>>,
    share: Array<'py, Complex<f64>>,
    lost: Vec<Lost>,
}

impl Found {
    fn new(described: &Described, asked: &Asked) -> Result<Self, Failure> {
        let design = described.build()?;
        let (inputs, outputs) = ports(&design, asked.inputs.as_deref(), asked.outputs.as_deref(), Ports::coordinates)?;
        let analysis = Analysis::new(design)?;
        let speeds = asked.speeds.clone().unwrap_or_else(|| reach::speeds(analysis.reach, false));
        let most = speeds.iter().copied().fold(0.0, f64::max);
        let of = Controllability::new(analysis, inputs, outputs);
        let rows = of.rows(&speeds)?;
        Ok(Self { lost: of.lost(most)?, speeds, rows, of })
    }

    fn measures(self) -> Measures {
        let moves = self.of.analysis.design.model.depends_on_speed();
        let names = |signals: &[Signal]| signals.iter().map(|signal| signal.name.clone()).collect();
        let lost =
            |of: LostTo| of.lost.into_iter().map(move |at| (of.name.clone(), of.is_input, at.speed, at.eigenvalue));
        Measures {
            speeds: moves.then(|| self.rows.iter().map(|row| row.speed).collect()),
            inputs: names(&self.of.inputs),
            outputs: names(&self.of.outputs),
            shape: [self.rows.len(), self.of.analysis.design.model.eigenvalues()],
            modes: self
                .rows
                .into_iter()
                .flat_map(|row| row.modes)
                .map(|(mode, own)| (mode.mode.to_string(), own))
                .collect(),
            lost: self.lost.into_iter().flat_map(lost).collect(),
        }
    }

    fn picture(&self) -> Result<String, Failure> {
        let model = self.of.analysis.design.model;
        if !model.depends_on_speed() {
            let nothing = format!("nothing in the model {} depends on the speed", model.info.name);
            return Err(Failure::usage(format!("{nothing}, so there is no graph against it")));
        }
        let speeds = self.speeds.iter();
        let (least, most) = speeds.fold((f64::INFINITY, 0.0_f64), |(low, high), v| (low.min(*v), high.max(*v)));
        if least >= most {
            return Err(Failure::usage("a picture needs a range of speeds: at least two in `v`"));
        }
        let rows = self.of.rows(&drawn(least, most, &self.lost))?;
        Ok(draw_controllability(&self.of, &rows).svg())
    }
}

impl Measures {
    fn told(self, py: Python<'_>) -> PyResult<Told<'_>> {
        let eigenvalues = self.modes.iter().map(|(_, own)| own.eigenvalue).collect();
        let (inputs, outputs) = (self.inputs.len(), self.outputs.len());
        Ok(Told {
            eigenvalues: PyArray1::from_vec(py, eigenvalues).reshape(self.shape)?.to_dyn().clone(),
            controllability: self.array(py, inputs, |own| &own.controllability)?,
            observability: self.array(py, outputs, |own| &own.observability)?,
            excitation: self.array(py, inputs, |own| &own.excitation)?,
            share: self.array(py, outputs, |own| &own.share)?,
            modes: self.modes.into_iter().map(|(name, _)| name).collect(),
            speeds: self.speeds,
            inputs: self.inputs,
            outputs: self.outputs,
            lost: self.lost,
        })
    }

    /// By speed, mode, and input or output.
    fn array<'py, T: Element + Copy>(
        &self,
        py: Python<'py>,
        ports: usize,
        of: fn(&ModalMeasures) -> &[T],
    ) -> PyResult<Array<'py, T>> {
        let values = self.modes.iter().flat_map(|(_, own)| of(own).iter().copied()).collect();
        let [speeds, modes] = self.shape;
        PyArray1::from_vec(py, values).reshape(vec![speeds, modes, ports])
    }
}

#[pymethods]
impl Designs {
    /// What excites and shows the modes of one design, along the speed.
    fn controllability<'py>(&self, py: Python<'py>, about: About, asked: Asked) -> PyResult<Told<'py>> {
        let described = self.described(py, about)?;
        py.detach(|| Ok(Found::new(&described, &asked)?.measures())).map_err(raise)?.told(py)
    }

    /// The picture of it, as SVG.
    fn controllability_svg(&self, py: Python<'_>, about: About, asked: Asked) -> PyResult<String> {
        let described = self.described(py, about)?;
        py.detach(|| Found::new(&described, &asked)?.picture()).map_err(raise)
    }
}
