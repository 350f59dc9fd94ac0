/** Writes scenes for POV-Ray 3.7. */
package simpleray.pov;
