carvallo::model! {
    pub model fn {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[m*l^2]];
    }
}

fn main() {}
