//! A program as the statements of a function.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::names::GeneratedNames;
use super::nesting::{self, Place, Strength};
use super::number;
use crate::model::Model;
use crate::program::{Instruction, Program, Value};

/// A program as statements, and each value as an expression.
pub struct Body {
    bindings: Vec<Binding>,
    pub values: Vec<TokenStream>,
    /// What each value's expression is to the operators around it.
    strengths: Vec<Strength>,
}

/// Values, one or a pair, the variables that hold them, and what is bound to these.
struct Binding {
    values: Vec<Value>,
    names: Vec<Ident>,
    expression: TokenStream,
}

/// What a program reads.
pub struct Inputs {
    /// As they are written.
    pub values: Vec<TokenStream>,
    /// For the names of functions of them.
    pub names: Vec<String>,
    /// The one that has as many lanes as there are.
    pub like: usize,
}

impl Inputs {
    /// The parameters of a model, from inside it.
    pub fn of_model(model: &Model) -> Self {
        let names = model.parameters.iter().map(|parameter| &parameter.name);
        Self {
            values: names.clone().map(|name| quote!(self.#name)).collect(),
            names: names.map(ToString::to_string).collect(),
            like: model.parameters.iter().position(|parameter| parameter.used).unwrap_or(0),
        }
    }
}

/// A program of more variables than this declares so many of them at once.
const MAX_SCOPES: usize = 250;

impl Body {
    /// Of the parameters of a model, with names for some of the values, as far as nothing else has them.
    pub fn new(program: &Program, model: &Model, names: &GeneratedNames, results: &[(Value, String)]) -> Self {
        Self::of(program, &Inputs::of_model(model), model, names, results)
    }

    /// Of any inputs.
    pub fn of(
        program: &Program,
        inputs: &Inputs,
        model: &Model,
        names: &GeneratedNames,
        results: &[(Value, String)],
    ) -> Self {
        let variable = names.values(program, model, &inputs.names, results);
        let mut body = Self { bindings: Vec::new(), values: Vec::new(), strengths: Vec::new() };
        for (value, (instruction, place)) in program.instructions.iter().zip(nesting::places(program)).enumerate() {
            match place {
                Place::Nested => {
                    let expression = body.expression(*instruction, inputs, names);
                    body.push(expression, Strength::of(*instruction));
                    continue;
                }
                Place::Variable => {
                    let expression = body.expression(*instruction, inputs, names);
                    body.bind(vec![value], expression, &variable);
                }
                Place::Pair { sine, cosine, is_first: true } => {
                    let angle = instruction.operands().next().unwrap_or_else(|| unreachable!("functions have one"));
                    let both = body.call("sin_cos", angle, names);
                    body.bind(vec![sine, cosine], both, &variable);
                }
                Place::Pair { .. } => {}
            }
            let name = variable(value);
            body.push(quote!(#name), Strength::Atom);
        }
        body
    }

    /// The bindings as statements.
    pub fn statements(&self) -> TokenStream {
        self.statements_with(|_| TokenStream::new())
    }

    /// The bindings as statements, each with what is done with its values as soon as they are there.
    ///
    /// Each `let` opens a scope inside the one before it, and thousands of them exhaust the stack of the compiler where
    /// it writes debug information. So long programs declare their variables in groups, and assign to them.
    pub fn statements_with(&self, done_with: impl Fn(Value) -> TokenStream) -> TokenStream {
        let statement = |binding: &Binding, keyword: TokenStream| {
            let Binding { values, names, expression } = binding;
            let pattern = if let [name] = &names[..] { quote!(#name) } else { quote!((#(#names),*)) };
            let done = values.iter().map(|value| done_with(*value));
            quote! { #keyword #pattern = #expression; #(#done)* }
        };
        if self.bindings.len() <= MAX_SCOPES {
            return self.bindings.iter().map(|binding| statement(binding, quote!(let))).collect();
        }
        let groups = self.bindings.chunks(MAX_SCOPES).map(|group| {
            let names = group.iter().flat_map(|binding| &binding.names);
            let assignments = group.iter().map(|binding| statement(binding, TokenStream::new()));
            quote! { let (#(#names,)*); #(#assignments)* }
        });
        groups.collect()
    }

    /// Whether a value has a variable.
    pub fn is_bound(&self, value: Value) -> bool {
        self.bindings.iter().any(|binding| binding.values.contains(&value))
    }

    fn bind(&mut self, values: Vec<Value>, expression: TokenStream, variable: impl Fn(Value) -> Ident) {
        let names = values.iter().map(|value| variable(*value)).collect();
        self.bindings.push(Binding { values, names, expression });
    }

    fn push(&mut self, expression: TokenStream, strength: Strength) {
        self.values.push(expression);
        self.strengths.push(strength);
    }

    /// A value as an operand: in parentheses if it holds together less than is needed there.
    fn operand(&self, value: Value, needed: Strength) -> TokenStream {
        let expression = &self.values[value];
        if self.strengths[value] >= needed { quote!(#expression) } else { quote!((#expression)) }
    }

    fn call(&self, function: &str, argument: Value, names: &GeneratedNames) -> TokenStream {
        // What stands between the parentheses of a call needs none of its own.
        let argument =
            if names.among_items { self.values[argument].clone() } else { self.operand(argument, Strength::Atom) };
        names.call(function, &argument, None)
    }

    fn expression(&self, instruction: Instruction, inputs: &Inputs, names: &GeneratedNames) -> TokenStream {
        // Operators of one strength are applied from the left.
        let sum = |a, sign: TokenStream, b| {
            let (a, b) = (self.operand(a, Strength::Sum), self.operand(b, Strength::Product));
            quote!(#a #sign #b)
        };
        let product = |a, sign: TokenStream, b| {
            let (a, b) = (self.operand(a, Strength::Product), self.operand(b, Strength::Atom));
            quote!(#a #sign #b)
        };
        let call = |function, argument| self.call(function, argument, names);
        match instruction {
            Instruction::Parameter(index) => inputs.values[index].clone(),
            Instruction::Constant(value) => constant(value, inputs, names),
            Instruction::Add(a, b) => sum(a, quote!(+), b),
            Instruction::Sub(a, b) => sum(a, quote!(-), b),
            Instruction::Mul(a, b) => product(a, quote!(*), b),
            Instruction::Div(a, b) => product(a, quote!(/), b),
            Instruction::Square(a) => product(a, quote!(*), a),
            Instruction::Neg(a) => {
                let a = self.operand(a, Strength::Atom);
                quote!(-#a)
            }
            Instruction::Reciprocal(a) => {
                let (one, a) = (constant(1.0, inputs, names), self.operand(a, Strength::Atom));
                quote!(#one / #a)
            }
            Instruction::Sqrt(a) => call("sqrt", a),
            Instruction::Sin(a) => call("sin", a),
            Instruction::Cos(a) => call("cos", a),
            Instruction::Tan(a) => call("tan", a),
            Instruction::Power(..) => unreachable!("the pass `powers` leaves none"),
        }
    }
}

/// A number, in as many lanes as the inputs have.
fn constant(value: f64, inputs: &Inputs, names: &GeneratedNames) -> TokenStream {
    names.call("like", &inputs.values[inputs.like], Some(&number(value)))
}
