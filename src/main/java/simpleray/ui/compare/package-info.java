/** Finished pictures: two of them side by side, how often each light occurs, and pixels that a screen cannot show. */
package simpleray.ui.compare;
