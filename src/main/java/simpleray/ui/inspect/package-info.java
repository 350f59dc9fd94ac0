/** Single pixels: their colours and their stories. */
package simpleray.ui.inspect;
