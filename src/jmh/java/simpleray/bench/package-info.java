/** Benchmarks: how long the single steps of a picture take. {@code gradle jmh} runs them. */
package simpleray.bench;
