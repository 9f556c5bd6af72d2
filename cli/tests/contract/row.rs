//! The columns of the CSV.

/// One line of the CSV.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    pub(crate) t: f64,
    pub(crate) x: f64,
    pub(crate) x_measured: f64,
    pub(crate) v: f64,
    pub(crate) f_env: f64,
    pub(crate) f_ctl: f64,
    pub(crate) f_out: f64,
    pub(crate) f_act: f64,
    pub(crate) observer: f64,
    pub(crate) alpha: f64,
    pub(crate) shortfall: f64,
    pub(crate) accepted: f64,
}

pub(crate) const HEADER: &str =
    "t,x,x_measured,v,f_env,f_ctl,f_out,f_act,observer,alpha,shortfall,accepted";

impl Row {
    pub(crate) fn columns(&self) -> [f64; 12] {
        [
            self.t,
            self.x,
            self.x_measured,
            self.v,
            self.f_env,
            self.f_ctl,
            self.f_out,
            self.f_act,
            self.observer,
            self.alpha,
            self.shortfall,
            self.accepted,
        ]
    }

    pub(crate) fn from_columns(columns: [f64; 12]) -> Self {
        let [t, x, x_measured, v, f_env, f_ctl, f_out, f_act, observer, alpha, shortfall, accepted] =
            columns;
        Self {
            t,
            x,
            x_measured,
            v,
            f_env,
            f_ctl,
            f_out,
            f_act,
            observer,
            alpha,
            shortfall,
            accepted,
        }
    }
}
