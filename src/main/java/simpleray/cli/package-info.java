/** The command line: thin commands over the other rooms, and the only {@code System.exit}. */
package simpleray.cli;
