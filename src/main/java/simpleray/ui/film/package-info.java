/** Films in the window: the time line, and what plays their frames. */
package simpleray.ui.film;
