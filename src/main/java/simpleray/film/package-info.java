/** Films: which frames there are, how they are numbered, and the files that hold many of them. */
package simpleray.film;
