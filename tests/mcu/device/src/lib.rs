//! Measures a task on a Cortex-M, and tells by semihosting what it took and gave.

#![no_std]

pub mod in_c;

use core::hint::black_box;

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m::register::msp;
use cortex_m_semihosting::debug;
use cortex_m_semihosting::hio::{HostStream, hstdout};
use tasks::Task;

/// The part of the stack that is looked at, in bytes.
const STACK: u32 = 16384;
const UNTOUCHED: u32 = 0xc0de_cafe;

/// Runs a task and ends the program.
pub fn run<T: Task>() -> ! {
    let input = T::input();
    let stack = stack(|| {
        black_box(T::run(black_box(&input)));
    });
    let ticks = ticks(|| {
        for _ in 0..T::TIMES {
            black_box(T::run(black_box(&input)));
        }
    });
    let empty = ticks_of_nothing::<T>();
    if let Ok(mut out) = hstdout() {
        say(&mut out, b"stack", u64::from(stack));
        say(&mut out, b"ticks", u64::from(ticks - empty));
        T::bits(&T::run(&input), &mut |bits| say(&mut out, b"bits", bits));
    }
    debug::exit(debug::EXIT_SUCCESS);
    loop {}
}

fn ticks_of_nothing<T: Task>() -> u32 {
    ticks(|| {
        for _ in 0..T::TIMES {
            black_box(());
        }
    })
}

/// What the clock of the processor counts meanwhile.
fn ticks(run: impl FnOnce()) -> u32 {
    if let Some(Peripherals { SYST: mut clock, .. }) = Peripherals::take() {
        clock.set_clock_source(SystClkSource::Core);
        clock.set_reload(0x00ff_ffff);
        clock.clear_current();
        clock.enable_counter();
    }
    let start = SYST::get_current();
    run();
    // It counts down.
    start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff
}

/// How many bytes of the stack are touched meanwhile.
#[inline(never)]
fn stack(run: impl FnOnce()) -> u32 {
    let top = msp::read() - 64;
    let bottom = top - STACK;
    // SAFETY: the memory below the stack pointer is nobody's, and is RAM for much more than this.
    for word in (bottom..top).step_by(4) {
        unsafe { (word as *mut u32).write_volatile(UNTOUCHED) };
    }
    run();
    let touched = (bottom..top).step_by(4).find(|&word| unsafe { (word as *const u32).read_volatile() } != UNTOUCHED);
    touched.map_or(0, |lowest| top + 64 - lowest)
}

/// A line of a word and a number in hexadecimal digits, without the formatting of `core`.
fn say(out: &mut HostStream, word: &[u8], number: u64) {
    let mut digits = *b" 0000000000000000\n";
    let mut rest = number;
    for digit in digits[1..17].iter_mut().rev() {
        let value = (rest & 15) as u8;
        *digit = if value < 10 { b'0' + value } else { b'a' + value - 10 };
        rest >>= 4;
    }
    let _ = out.write_all(word);
    let _ = out.write_all(&digits);
}

/// Nothing that is measured may panic: `costs` refuses a program in which this is linked.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    debug::exit(debug::EXIT_FAILURE);
    loop {}
}
