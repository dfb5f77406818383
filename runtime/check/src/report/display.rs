//! A report for people.

use std::fmt::{self, Display};

use carvallo_design::number::{shortest, unit};

use super::words::may_be_closed;
use super::{Behind, Comparison, Elsewhere, Group, Part, Report, Suspects};

/// So many numbers are shown at most unless they are wrong, and so many explanations of a group, and groups.
const NUMBERS: usize = 48;
const EXPLANATIONS: usize = 6;
const GROUPS: usize = 6;

impl Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { machine, model, numbers, .. } = self;
        writeln!(f, "Held against {machine}, by the equations of {model}\n")?;
        let shown: Vec<&Comparison> =
            numbers.iter().filter(|number| numbers.len() <= NUMBERS || !number.agrees).collect();
        let is_wrong = |number: &&Comparison| !number.agrees && number.cut_off.is_none();
        let wrong = numbers.iter().filter(is_wrong).count();
        let cut = numbers.iter().filter(|number| number.cut_off.is_some()).count();
        if !shown.is_empty() {
            table(&shown, f)?;
            match numbers.len() - shown.len() {
                0 => {}
                others => writeln!(f, "  and {others} that agree")?,
            }
            let mut states = self.states.clone();
            states.dedup();
            self.reasons.iter().try_for_each(|why| writeln!(f, "  None of ours {why}"))?;
            states.iter().try_for_each(|own| writeln!(f, "  Rows and columns of A: {}", own.join(", ")))?;
            writeln!(f)?;
        }
        match &self.unknown[..] {
            [] => {}
            [one] => writeln!(f, "Not known, and not compared, is {one}.")?,
            all => writeln!(f, "Not known, and not compared, are {}.", all.join(", "))?,
        }
        let first = numbers.iter().find_map(|own| Some((own, own.ours?, own.cut_off.as_ref()?)));
        if let Some((Comparison { yours, .. }, value, rounded)) = first {
            match (cut, numbers.len()) {
                (1, 1) => writeln!(f, "The number is cut off, not rounded:")?,
                (1, count) => writeln!(f, "1 of {count} numbers is cut off, not rounded:")?,
                (cut, count) => writeln!(f, "{cut} of {count} numbers are cut off, not rounded:")?,
            }
            writeln!(f, "  {yours} is {} cut off; rounded it is {rounded}\n", shown_value(yours, value))?;
        }
        match (wrong, numbers.len()) {
            (0, count) if cut > 0 => {
                let others =
                    if cut == count { "Nothing else differs." } else { "All others agree to all digits given." };
                writeln!(f, "{others}")?;
                if self.explanations.is_empty() {
                    return Ok(());
                }
                writeln!(f, "\nBut if all numbers are rounded, there is another cause.")?;
            }
            (0, 1) => return writeln!(f, "The number agrees to all digits given."),
            (0, count) => return writeln!(f, "All {count} numbers agree to all digits given."),
            (1, 1) => writeln!(f, "The number does not agree.")?,
            (1, count) => writeln!(f, "1 of {count} numbers does not agree.")?,
            (wrong, count) => writeln!(f, "{wrong} of {count} numbers do not agree.")?,
        }
        if let Some(digits) = self.padded.filter(|_| wrong > 0) {
            writeln!(
                f,
                "To {digits} digits all agree, with zeros behind: `digits = {digits}` in the file says that no more are known."
            )?;
        }
        match &self.unexplained {
            Some(suspects) => suspects.fmt(self.stopped_short, f)?,
            None => explanations(&self.explanations, numbers.len(), f)?,
        }
        if self.stopped_short {
            writeln!(
                f,
                "The search stopped short: critical speeds of so many coordinates take long, and not everything of two together was tried."
            )?;
        }
        Ok(())
    }
}

fn table(numbers: &[&Comparison], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let ours = |number: &Comparison| match number.ours {
        None => "none".to_owned(),
        Some(value) => shown_value(&number.yours, value),
    };
    let rows: Vec<[String; 5]> = numbers
        .iter()
        .map(|number| {
            let digits = match (number.agrees, number.digits) {
                (false, digits) if number.cut_off.is_some() => format!("{digits}, cut off"),
                (true, 0) => "all".to_owned(),
                (true, digits) => format!("all {digits}"),
                (false, digits) => format!("{digits}, differs"),
            };
            [number.name.clone(), unit(&number.unit), number.yours.clone(), ours(number), digits]
        })
        .collect();
    let width =
        |column: usize, title: &str| rows.iter().map(|row| row[column].chars().count()).fold(title.len(), usize::max);
    let [name, unit] = [width(0, "number"), width(1, "")];
    let [yours, own] = [width(2, "yours"), width(3, "ours")];
    writeln!(f, "  {:<name$}  {:unit$}  {:>yours$}  {:>own$}  digits that agree", "number", "", "yours", "ours")?;
    for [label, symbol, given, value, digits] in &rows {
        writeln!(f, "  {label:<name$}  {symbol:<unit$}  {given:>yours$}  {value:>own$}  {digits}")?;
    }
    Ok(())
}

/// A number with two digits more than one beside it was given to.
fn shown_value(yours: &str, value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let written = yours.chars().filter(char::is_ascii_digit).count();
    let digits = (written + 2).clamp(6, 17);
    shortest(format!("{value:.*e}", digits - 1).parse().unwrap_or(value))
}

fn explanations(groups: &[Group], count: usize, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let all = if count == 1 { "It comes out as yours if" } else { "All come out as yours if" };
    for (at, group) in groups.iter().take(GROUPS).enumerate() {
        writeln!(f, "\n{}", if at == 0 { all } else { "or if" })?;
        for (at, explanation) in group.explanations.iter().take(EXPLANATIONS).enumerate() {
            let or = if at == 0 { "" } else { "or " };
            writeln!(f, "  {or}{}", explanation.causes.join(",\n    and "))?;
        }
        let more = group.explanations.len().saturating_sub(EXPLANATIONS);
        if more > 0 {
            writeln!(f, "  or {more} more that {} the same numbers", if more == 1 { "makes" } else { "make" })?;
        }
        if group.explanations.len() > 1 {
            let is_one = group.explanations.iter().all(|explanation| explanation.class == 0);
            match is_one {
                true => writeln!(f, "  No numbers tell these apart: they are the same for every machine.")?,
                false => writeln!(f, "  No numbers of this machine tell these apart; those of another one do.")?,
            }
        }
        if let Some(apart) = &group.apart {
            writeln!(f, "  What would tell: {apart}.")?;
        }
    }
    let apart = "with other numbers; more digits or other numbers tell them apart.";
    match groups.len().saturating_sub(GROUPS) {
        0 => Ok(()),
        1 => writeln!(f, "\nThere is 1 more way, {apart}"),
        more => writeln!(f, "\nThere are {more} more ways, {apart}"),
    }
}

impl Suspects {
    fn fmt(&self, is_short: bool, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            contradictions,
            beside,
            wrong,
            has_few_digits,
            formulas,
            parts,
            elsewhere,
            behind,
            equations,
            feedback,
        } = self;
        let is_closed = feedback.as_ref().is_some_and(|own| !own.laws.is_empty());
        let what = match (self.are_explained_one_by_one(), is_closed) {
            (true, _) => {
                "There are several mistakes: nothing that was tried explains all numbers at once, but each by itself is."
            }
            _ if elsewhere.is_some() => {
                "No machine that was tried has all of these numbers, but one has all of those that do not agree."
            }
            (_, true) => "No slip and no convention explains all numbers, but a feedback that is not declared does.",
            _ if *has_few_digits => {
                "No single slip and no convention explains all numbers. They have too few digits to tell of two together, which were not tried."
            }
            _ if is_short => {
                "Nothing that was tried explains all numbers: no single slip, no convention and none of the pairs of them that were tried."
            }
            _ => {
                "Nothing that was tried explains all numbers: no single slip, no convention and no two of them together."
            }
        };
        match &contradictions[..] {
            [] if beside.is_empty() => writeln!(f, "\n{what}")?,
            [] => writeln!(f, "\n{}. Beside that:\n{what}", beside.join(", "))?,
            all => {
                if !beside.is_empty() {
                    write!(f, "\n{}. Beside that:", beside.join(", "))?;
                }
                writeln!(f, "\nNo machine has all of these numbers: {}.", all.join(", "))?;
            }
        }
        writeln!(f, "  What differs: {}", wrong.join(", "))?;
        if !formulas.is_empty() {
            let these = if formulas.len() == 1 { "this formula" } else { "each of these formulas" };
            writeln!(f, "  All that differs depends on {these}, and nothing that agrees does:")?;
            formulas.iter().try_for_each(|formula| writeln!(f, "    {formula}"))?;
        }
        if !parts.is_empty() {
            writeln!(f, "  By itself, without a change of what agrees,")?;
            parts.iter().try_for_each(|part| part.fmt(f))?;
        }
        elsewhere.iter().try_for_each(|own| own.fmt(f))?;
        behind.iter().try_for_each(|behind| behind.fmt(f))?;
        if !equations.is_empty() {
            writeln!(f, "  Of the equations of motion are off")?;
            equations.iter().try_for_each(|own| writeln!(f, "    {own}"))?;
        }
        feedback.iter().try_for_each(|what| writeln!(f, "  {}", may_be_closed(what)))
    }
}

impl Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { numbers, causes } = self;
        let come = if numbers.len() == 1 { "comes" } else { "come" };
        writeln!(f, "  {} {come} out as yours if\n    {}", numbers.join(", "), causes.join("\n    or "))
    }
}

impl Display for Elsewhere {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { agreeing, causes } = self;
        let agreeing = agreeing.join(" and as ");
        writeln!(f, "  What is given as {agreeing} agrees. All others come out as yours, and that does not, if")?;
        writeln!(f, "    {}", causes.join("\n    or "))
    }
}

impl Display for Behind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { wrong, count, parts } = self;
        writeln!(f, "  Behind A = [0, 1; -M^-1 K, -M^-1 C] stand, with M as it is here,")?;
        wrong.iter().take(NUMBERS).try_for_each(|entry| writeln!(f, "    {entry}"))?;
        if wrong.len() == *count {
            writeln!(f, "  That is all of C and K: M is likely to be another one.")?;
        }
        parts.iter().try_for_each(|part| part.fmt(f))
    }
}
