carvallo::model! {
    pub model Pendulum {
        parameters {
            l: m, > 0;
            a: rad;
        }

        let x = l*sin(a);
        assert x == -l*cos(a + pi/2);
        assert x == l*cos(a + pi/2);

        coordinates {
            theta: rad;
        }

        M = [[x*l*1 [kg]]];
    }
}

fn main() {}
