/** Reads the scenes of other programs. */
package simpleray.convert;
