//! The subcommands in the help of the program, by what they are for.

use std::fmt::Write as _;

use clap::Command;

/// What is asked, and the subcommands that answer it.
const GROUPS: [(&str, &[&str]); 6] = [
    ("Stability", &["analyze", "compare", "sensitivity", "sweep", "optimize"]),
    ("Motion", &["simulate", "turns"]),
    ("Control", &["statespace", "transfer", "respond", "controllability", "lqr"]),
    ("Parameters", &["bicycles", "show", "convert", "measure", "rider"]),
    ("Models", &["models", "equations"]),
    ("Checks", &["check"]),
];

/// The program with its subcommands in groups, each with what it says of itself.
pub fn grouped(command: Command) -> Command {
    let styles = command.get_styles();
    let (header, literal) = (*styles.get_header(), *styles.get_literal());
    let width = command.get_subcommands().map(|own| own.get_name().len()).max().unwrap_or(0);
    let mut text = String::new();
    for (group, names) in GROUPS {
        // Text in memory takes everything.
        let _ = writeln!(text, "{header}{group}:{header:#}");
        for own in names.iter().filter_map(|name| command.find_subcommand(name)) {
            let (name, about) = (own.get_name(), own.get_about().map(ToString::to_string).unwrap_or_default());
            let _ = writeln!(text, "  {literal}{name}{literal:#}{:1$}  {about}", "", width - name.len());
        }
        text.push('\n');
    }
    let template = "{about-with-newline}\n{usage-heading} {usage}\n\n";
    command.help_template(format!("{template}{text}{header}Options:{header:#}\n{{options}}{{after-help}}"))
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::GROUPS;
    use crate::commands::Arguments;

    #[test]
    fn each_subcommand_is_in_one_group() {
        let command = Arguments::command();
        let mut names: Vec<&str> = command.get_subcommands().map(|own| own.get_name()).collect();
        let mut grouped: Vec<&str> = GROUPS.iter().flat_map(|(_, names)| names.iter().copied()).collect();
        names.sort_unstable();
        grouped.sort_unstable();
        assert_eq!(names, grouped);
    }
}
