/** A scene made ready for fast rendering, and what finds hits in it. */
package simpleray.trace;
