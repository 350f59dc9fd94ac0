/** Files: written whole or not at all, by one run at a time, and digested while they are read. Knows no format. */
package simpleray.io;
