//! Provisional, by hand, until the compiler writes it.
#![allow(non_snake_case, missing_docs)]
use carvallo::*;
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Whipple<T = f64> {
    pub w: T,
    pub c: T,
    pub lam: T,
    pub g: T,
    pub rR: T,
    pub mR: T,
    pub IRxx: T,
    pub IRyy: T,
    pub xB: T,
    pub zB: T,
    pub mB: T,
    pub IBxx: T,
    pub IByy: T,
    pub IBzz: T,
    pub IBxz: T,
    pub xH: T,
    pub zH: T,
    pub mH: T,
    pub IHxx: T,
    pub IHyy: T,
    pub IHzz: T,
    pub IHxz: T,
    pub rF: T,
    pub mF: T,
    pub IFxx: T,
    pub IFyy: T,
}
impl Whipple<f64> {
    pub const BENCHMARK: Self = Self { w: 1.02, c: 0.08, lam: 0.3141592653589793, g: 9.81, rR: 0.3, mR: 2.0, IRxx: 0.0603, IRyy: 0.12, xB: 0.3, zB: -0.9, mB: 85.0, IBxx: 9.2, IByy: 11.0, IBzz: 2.8, IBxz: 2.4, xH: 0.9, zH: -0.7, mH: 4.0, IHxx: 0.05892, IHyy: 0.06, IHzz: 0.00708, IHxz: -0.00756, rF: 0.35, mF: 3.0, IFxx: 0.1405, IFyy: 0.28 };
}
static INFO: ModelInfo = ModelInfo { name: "Whipple", docs: "The Whipple-Carvallo bicycle.", source: "Meijaard et al. 2007", gravity: Some(3), sets: &[SetInfo { name: "benchmark", docs: "", source: "", values: &[1.02, 0.08, 0.3141592653589793, 9.81, 0.3, 2.0, 0.0603, 0.12, 0.3, -0.9, 85.0, 9.2, 11.0, 2.8, 2.4, 0.9, -0.7, 4.0, 0.05892, 0.06, 0.00708, -0.00756, 0.35, 3.0, 0.1405, 0.28] }], coordinates: &[CoordinateInfo { name: "phi", label: "lean", docs: "", unit: "rad" }, CoordinateInfo { name: "delta", label: "steer", docs: "", unit: "rad" }], parameters: &[
    ParameterInfo { name: "w", symbol: "w", docs: "", unit: "m", domain: Domain { lower: Bound::Open(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "c", symbol: "c", docs: "", unit: "m", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "lam", symbol: "λ", docs: "", unit: "rad", domain: Domain { lower: Bound::Open(-1.5707963267948966), upper: Bound::Open(1.5707963267948966) }, used: true },
    ParameterInfo { name: "g", symbol: "g", docs: "", unit: "N/kg", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "rR", symbol: "rR", docs: "", unit: "m", domain: Domain { lower: Bound::Open(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "mR", symbol: "mR", docs: "", unit: "kg", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IRxx", symbol: "IRxx", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IRyy", symbol: "IRyy", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "xB", symbol: "xB", docs: "", unit: "m", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "zB", symbol: "zB", docs: "", unit: "m", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "mB", symbol: "mB", docs: "", unit: "kg", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IBxx", symbol: "IBxx", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IByy", symbol: "IByy", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: false },
    ParameterInfo { name: "IBzz", symbol: "IBzz", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IBxz", symbol: "IBxz", docs: "", unit: "kg*m^2", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "xH", symbol: "xH", docs: "", unit: "m", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "zH", symbol: "zH", docs: "", unit: "m", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "mH", symbol: "mH", docs: "", unit: "kg", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IHxx", symbol: "IHxx", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IHyy", symbol: "IHyy", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: false },
    ParameterInfo { name: "IHzz", symbol: "IHzz", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IHxz", symbol: "IHxz", docs: "", unit: "kg*m^2", domain: Domain::FINITE, used: true },
    ParameterInfo { name: "rF", symbol: "rF", docs: "", unit: "m", domain: Domain { lower: Bound::Open(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "mF", symbol: "mF", docs: "", unit: "kg", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IFxx", symbol: "IFxx", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
    ParameterInfo { name: "IFyy", symbol: "IFyy", docs: "", unit: "kg*m^2", domain: Domain { lower: Bound::Closed(0.0), upper: Bound::Unbounded }, used: true },
] };
impl<T: Scalar> Model<2> for Whipple<T> {
    type Scalar = T;
    const INFO: &'static ModelInfo = &INFO;
    fn from_slice(v: &[T]) -> Result<Self, LengthError> {
        if v.len() != 26 { return Err(LengthError { model: "Whipple", expected: 26, found: v.len() }); }
        Ok(Self { w: v[0], c: v[1], lam: v[2], g: v[3], rR: v[4], mR: v[5], IRxx: v[6], IRyy: v[7], xB: v[8], zB: v[9], mB: v[10], IBxx: v[11], IByy: v[12], IBzz: v[13], IBxz: v[14], xH: v[15], zH: v[16], mH: v[17], IHxx: v[18], IHyy: v[19], IHzz: v[20], IHxz: v[21], rF: v[22], mF: v[23], IFxx: v[24], IFyy: v[25] })
    }
    fn write_to(&self, v: &mut [T]) -> Result<(), LengthError> {
        if v.len() != 26 { return Err(LengthError { model: "Whipple", expected: 26, found: v.len() }); }
        v.copy_from_slice(&[self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB, self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH, self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy]);
        Ok(())
    }
    fn validate(&self) -> Result<(), ParameterError> {
        for (p, v) in INFO.parameters.iter().zip([self.w, self.c, self.lam, self.g, self.rR, self.mR, self.IRxx, self.IRyy, self.xB, self.zB, self.mB, self.IBxx, self.IByy, self.IBzz, self.IBxz, self.xH, self.zH, self.mH, self.IHxx, self.IHyy, self.IHzz, self.IHxz, self.rF, self.mF, self.IFxx, self.IFyy]) {
            if !p.domain.contains(v.to_f64()) { return Err(ParameterError { model: "Whipple", subject: p.name, value: v.to_f64(), unit: p.unit, required: p.domain }); }
        }
        let v = (self.mH + self.mF).to_f64();
        let positive = Domain { lower: Bound::Open(0.0), upper: Bound::Unbounded };
        if !positive.contains(v) { return Err(ParameterError { model: "Whipple", subject: "mH + mF", value: v, unit: "kg", required: positive }); }
        Ok(())
    }
    fn gravity(&self) -> Option<T> { Some(self.g) }
    fn coefficients(&self) -> Coefficients<T, 2> {
        let Self { w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IByy, IBzz, IBxz, xH, zH, mH, IHxx, IHyy, IHzz, IHxz, rF, mF, IFxx, IFyy } = *self; let _ = (g, IByy, IHyy);
        let (sl, cl) = lam.sin_cos();
        let mT = mR + mB + mH + mF;
        let xT = (xB*mB + xH*mH + w*mF)/mT; let zT = (-rR*mR + zB*mB + zH*mH - rF*mF)/mT;
        let ITxx = IRxx + IBxx + IHxx + IFxx + mR*rR*rR + mB*zB*zB + mH*zH*zH + mF*rF*rF;
        let ITxz = IBxz + IHxz - mB*xB*zB - mH*xH*zH + mF*w*rF;
        let ITzz = IRxx + IBzz + IHzz + IFxx + mB*xB*xB + mH*xH*xH + mF*w*w;
        let mA = mH + mF; let xA = (xH*mH + w*mF)/mA; let zA = (zH*mH - rF*mF)/mA;
        let IAxx = IHxx + IFxx + mH*(zH - zA)*(zH - zA) + mF*(rF + zA)*(rF + zA);
        let IAxz = IHxz - mH*(xH - xA)*(zH - zA) + mF*(w - xA)*(rF + zA);
        let IAzz = IHzz + IFxx + mH*(xH - xA)*(xH - xA) + mF*(w - xA)*(w - xA);
        let uA = (xA - w - c)*cl - zA*sl;
        let two = T::from_f64(2.0);
        let IAll = mA*uA*uA + IAxx*sl*sl + two*IAxz*sl*cl + IAzz*cl*cl;
        let IAlx = -mA*uA*zA + IAxx*sl + IAxz*cl;
        let IAlz = mA*uA*xA + IAxz*sl + IAzz*cl;
        let mu = c/w*cl; let SR = IRyy/rR; let SF = IFyy/rF; let ST = SR + SF; let SA = mA*uA + mu*mT*xT;
        let o = T::from_f64(0.0); let z = [[o; 2]; 2];
        let m12 = IAlx + mu*ITxz;
        Coefficients::from_rows([
            [[ITxx, m12], [m12, IAll + two*mu*IAlz + mu*mu*ITzz]],
            z,
            [[o, mu*ST + SF*cl + ITxz/w*cl - mu*mT*zT], [-(mu*ST + SF*cl), IAlz/w*cl + mu*(SA + ITzz/w*cl)]],
            z,
            [[mT*zT, -SA], [-SA, -SA*sl]],
            [[o, (ST - mT*zT)/w*cl], [o, (SA + SF*sl)/w*cl]],
        ])
    }
}
