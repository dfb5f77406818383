#![no_std]
#![no_main]

#[cortex_m_rt::entry]
fn main() -> ! {
    device::run::<device::in_c::StateSpaceF32>()
}
