//! Scheduled gains in C.

use super::{Text, rows, speed};

const HEAD: &str = " *
 * The inputs are -K x for the state x; all are small deviations from the steady motion, in SI units. Written by Carvallo; it is
 * C99 and C++ without any header.
 */

enum { REGULATOR_INPUTS = @inputs, REGULATOR_STATES = @states };
";

const ONE: &str = "
void regulator_inputs(const double states[REGULATOR_STATES], double inputs[REGULATOR_INPUTS]);

/* The gains K: a row for each input, and a column for each state. */
static const double regulator_table[REGULATOR_INPUTS][REGULATOR_STATES] = @gains;

/* The inputs for a state. */
void regulator_inputs(const double states[REGULATOR_STATES], double inputs[REGULATOR_INPUTS])
{
    int input;
    int state;
    for (input = 0; input < REGULATOR_INPUTS; ++input) {
        inputs[input] = 0.0;
        for (state = 0; state < REGULATOR_STATES; ++state) {
            inputs[input] -= regulator_table[input][state] * states[state];
        }
    }
}
";

const SCHEDULED: &str = "
enum { REGULATOR_COUNT = @count };

void regulator_gains(double speed, double gains[REGULATOR_INPUTS][REGULATOR_STATES]);
void regulator_inputs(double speed, const double states[REGULATOR_STATES], double inputs[REGULATOR_INPUTS]);

/* The speeds that there are gains for, in m/s, ascending. */
static const double regulator_speeds[REGULATOR_COUNT] = {@speeds};

/* The gains K at each of the speeds: a row for each input, and a column for each state. */
static const double regulator_table[REGULATOR_COUNT][REGULATOR_INPUTS][REGULATOR_STATES] = {
@gains};

/* The gains at a forward speed in m/s: between those of the table linearly, and beyond its ends those there. */
void regulator_gains(double speed, double gains[REGULATOR_INPUTS][REGULATOR_STATES])
{
    int index = 0;
    int input;
    int state;
    double part = 0.0;
    while (index + 1 < REGULATOR_COUNT && speed >= regulator_speeds[index + 1]) {
        ++index;
    }
    if (index + 1 < REGULATOR_COUNT && speed > regulator_speeds[index]) {
        part = (speed - regulator_speeds[index]) / (regulator_speeds[index + 1] - regulator_speeds[index]);
    }
    for (input = 0; input < REGULATOR_INPUTS; ++input) {
        for (state = 0; state < REGULATOR_STATES; ++state) {
            const double before = regulator_table[index][input][state];
            gains[input][state] = before;
            if (part > 0.0) {
                gains[input][state] += part * (regulator_table[index + 1][input][state] - before);
            }
        }
    }
}

/* The inputs at a forward speed in m/s, for a state. */
void regulator_inputs(double speed, const double states[REGULATOR_STATES], double inputs[REGULATOR_INPUTS])
{
    double gains[REGULATOR_INPUTS][REGULATOR_STATES];
    int input;
    int state;
    regulator_gains(speed, gains);
    for (input = 0; input < REGULATOR_INPUTS; ++input) {
        inputs[input] = 0.0;
        for (state = 0; state < REGULATOR_STATES; ++state) {
            inputs[input] -= gains[input][state] * states[state];
        }
    }
}
";

pub fn write(text: &Text) -> String {
    let [inputs, states, count] = text.counts();
    let mut about = String::new();
    for (index, line) in text.about.iter().enumerate() {
        let head = if index == 0 { "/*" } else { " *" };
        about.push_str(format!("{head} {line}").trim_end());
        about.push('\n');
    }
    let head = HEAD.replace("@inputs", &inputs.to_string()).replace("@states", &states.to_string());
    let regulators = &text.schedule.regulators;
    let own = if count == 1 {
        ONE.replace("@gains", &rows(text.first(), ['{', '}']))
    } else {
        let speeds: Vec<String> =
            regulators.iter().filter_map(|own| own.space.speed).map(|speed| format!("{speed:?}")).collect();
        let gains = regulators.iter().map(|own| format!("    {}, /* {} */\n", rows(own, ['{', '}']), speed(own)));
        SCHEDULED
            .replace("@count", &count.to_string())
            .replace("@speeds", &speeds.join(", "))
            .replace("@gains", &gains.collect::<String>())
    };
    [about.as_str(), &head, &own].concat()
}
