//! Disassembly by `objdump`, which knows every kind of file and processor.

use std::fmt;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::Command;

use super::listing::mnemonic;

/// How long a function may be that only calls another one.
const CALLER: usize = 12;
/// How many functions may call each other so.
const CALLERS: usize = 3;

/// Why there is no listing.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AssemblyError {
    /// This program does not find its own file.
    NoProgram(String),
    /// `objdump` is not installed.
    NoObjdump,
    /// `objdump` does not read the file.
    Failed(String),
    /// The file has no names of functions: `strip` took them out.
    NoSymbols(PathBuf),
}

impl fmt::Display for AssemblyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoProgram(error) => write!(f, "this program does not find its own file: {error}"),
            Self::NoObjdump => f.write_str(
                "`objdump` is not installed, and is needed to disassemble: it is part of binutils and of LLVM",
            ),
            Self::Failed(error) => write!(f, "`objdump` does not read this program: {error}"),
            Self::NoSymbols(file) => {
                write!(f, "{}: it has no names of functions; build it without `strip`", file.display())
            }
        }
    }
}

impl std::error::Error for AssemblyError {}

/// The program that is running, as a file.
pub struct Program {
    file: PathBuf,
    /// Where functions begin in the file, and how long they are, in ascending order.
    functions: Vec<(u64, u64)>,
    /// What is added to an address in the file to have that in this process.
    offset: u64,
}

/// A function whose place is known in the file, by its name, and in this process.
#[inline(never)]
fn carvallo_compare_is_here() -> &'static str {
    "carvallo_compare_is_here"
}

impl Program {
    pub fn of_this_process() -> Result<Self, AssemblyError> {
        let file = std::env::current_exe().map_err(|error| AssemblyError::NoProgram(error.to_string()))?;
        let here: fn() -> &'static str = carvallo_compare_is_here;
        let table = objdump(&["-t".into(), file.clone().into()])?;
        let symbols: Vec<(u64, u64, &str)> = table.lines().filter_map(symbol).collect();
        let named = symbols.iter().find(|(.., name)| name.contains(here()));
        let Some((begin, ..)) = named else { return Err(AssemblyError::NoSymbols(file)) };
        let offset = (here as usize as u64).wrapping_sub(*begin);
        let mut functions: Vec<(u64, u64)> = symbols.iter().map(|(begin, size, _)| (*begin, *size)).collect();
        functions.sort_unstable();
        functions.dedup_by_key(|function| function.0);
        Ok(Self { file, functions, offset })
    }

    /// The instructions of the function at an address of this process. One that does nothing but call another one is that.
    pub fn disassemble(&self, address: usize) -> Result<Vec<String>, AssemblyError> {
        let mut begin = (address as u64).wrapping_sub(self.offset);
        let mut lines = self.lines(begin)?;
        for _ in 0..CALLERS {
            let Some(called) = only_call(&lines).filter(|called| *called != begin) else { break };
            begin = called;
            lines = self.lines(begin)?;
        }
        Ok(lines)
    }

    /// The instructions from an address of the file on, to the end of the function.
    fn lines(&self, begin: u64) -> Result<Vec<String>, AssemblyError> {
        let next = self.functions.partition_point(|(other, _)| *other <= begin);
        // Some formats of files know no sizes.
        let size = self.functions[..next].last().map_or(0, |(_, size)| *size);
        let end = match size {
            0 => self.functions.get(next).map_or(u64::MAX, |(end, _)| *end),
            size => begin + size,
        };
        let mut arguments: Vec<_> = ["-d", "-C", "--no-show-raw-insn"].map(Into::into).into();
        if cfg!(any(target_arch = "x86", target_arch = "x86_64")) {
            arguments.extend(["-M", "intel"].map(Into::into));
        }
        arguments.extend([format!("--start-address={begin:#x}"), format!("--stop-address={end:#x}")].map(Into::into));
        arguments.push(self.file.clone().into());
        let text = objdump(&arguments)?;
        Ok(text.lines().filter_map(instruction).filter(|line| !is_filling(line)).collect())
    }
}

/// The address that the only call or jump out of a short function leads to.
fn only_call(lines: &[String]) -> Option<u64> {
    let is_call = |line: &&String| matches!(mnemonic(line), "call" | "jmp" | "bl" | "b");
    let mut calls = lines.iter().filter(is_call);
    let call = calls.next().filter(|_| lines.len() <= CALLER && calls.next().is_none())?;
    let target = call.split_whitespace().nth(1)?;
    u64::from_str_radix(target.trim_start_matches("0x"), 16).ok()
}

/// What fills the room behind a function.
fn is_filling(line: &str) -> bool {
    matches!(mnemonic(line), "nop" | "int3" | "xchg" | "data16" | "cs")
        && (line.contains("nop") || line.contains("ax,ax") || line == "int3")
}

/// A function of the table of symbols: where it begins, its size, its name.
fn symbol(line: &str) -> Option<(u64, u64, &str)> {
    // `0000000000001140 l     F .text  0000000000000045 _ZN…`
    let (begin, rest) = line.split_once(' ')?;
    let begin = u64::from_str_radix(begin, 16).ok()?;
    let mut words = rest.split_whitespace().skip_while(|word| *word != "F").skip(2);
    let size = words.next()?;
    match u64::from_str_radix(size, 16) {
        Ok(size) if size_is_a_number(rest) => Some((begin, size, words.last()?)),
        _ => Some((begin, 0, size)),
    }
}

/// Whether a size stands before the name, as ELF has it behind a tab.
fn size_is_a_number(rest: &str) -> bool {
    rest.contains('\t')
}

/// An instruction of a disassembly: `    1140:  mov    rax,rdi`.
fn instruction(line: &str) -> Option<String> {
    let (address, text) = line.split_once(':')?;
    let is_address = !address.trim().is_empty() && address.trim().bytes().all(|byte| byte.is_ascii_hexdigit());
    let words: Vec<&str> = text.split('#').next()?.split_whitespace().collect();
    (is_address && !words.is_empty()).then(|| words.join(" "))
}

fn objdump(arguments: &[std::ffi::OsString]) -> Result<String, AssemblyError> {
    let output = Command::new("objdump").args(arguments).output().map_err(|error| match error.kind() {
        ErrorKind::NotFound => AssemblyError::NoObjdump,
        _ => AssemblyError::Failed(error.to_string()),
    })?;
    if !output.status.success() {
        return Err(AssemblyError::Failed(String::from_utf8_lossy(&output.stderr).trim().to_owned()));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_both_objdumps_are_read() {
        let gnu = "0000000000001140 l     F .text\t0000000000000045              _ZN4here17h01E";
        assert_eq!(symbol(gnu), Some((0x1140, 0x45, "_ZN4here17h01E")));
        let hidden = "0000000000001140 g     F .text\t0000000000000045 .hidden here";
        assert_eq!(symbol(hidden), Some((0x1140, 0x45, "here")));
        let mach = "0000000100001140 l     F __TEXT,__text __ZN4here17h01E";
        assert_eq!(symbol(mach), Some((0x1_0000_1140, 0, "__ZN4here17h01E")));
        assert_eq!(symbol("0000000000000000 l    df *ABS*\t0000000000000000 file.c"), None);
        assert_eq!(instruction("    1140:\tmulsd  xmm0,xmm1   # 0x20").as_deref(), Some("mulsd xmm0,xmm1"));
        assert_eq!(instruction("0000000000001140 <here>:"), None);
        assert_eq!(instruction("file:     file format elf64-x86-64"), None);
    }

    #[test]
    fn a_function_that_only_calls_is_what_it_calls() {
        let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(only_call(&lines("mov rdi,rsi\njmp 1a40 <by_hand>")), Some(0x1a40));
        assert_eq!(only_call(&lines("call 1a40 <sin>\ncall 1b40 <cos>")), None);
        assert_eq!(only_call(&lines("mulsd xmm0,xmm1\nret")), None);
    }
}
