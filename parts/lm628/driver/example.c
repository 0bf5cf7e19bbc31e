/* SPDX-License-Identifier: Apache-2.0
 *
 * AN-693's absolute move, on any port: initialisation, filter, trajectory, wait, position.
 */
#include "example.h"

#include <stddef.h>

lm628_error lm628_example_move(const lm628_port *port, int32_t target, int32_t *reached) {
  static const lm628_filter filter = {LM628_KP | LM628_KD, 50, 0, 1000, 0, 4};
  lm628_trajectory move;
  lm628_device part;
  lm628_error error = lm628_init(&part, port);
  move.control = LM628_LOAD_ACCELERATION | LM628_LOAD_VELOCITY | LM628_LOAD_POSITION;
  move.acceleration = 1000; /* 2^-16 count/sample^2 */
  move.velocity = 100000;   /* 2^-16 count/sample */
  move.position = target;
  if (error == LM628_OK) error = lm628_reset(&part, LM628_OUTPUT_12_BITS);
  if (error == LM628_OK) error = lm628_load_filter(&part, &filter);
  if (error == LM628_OK) error = lm628_update_filter(&part);
  if (error == LM628_OK) error = lm628_stop_on_error(&part, 2000);
  if (error == LM628_OK) error = lm628_load_trajectory(&part, &move);
  if (error == LM628_OK) error = lm628_start(&part);
  if (error == LM628_OK) error = lm628_check(&part);
  if (error == LM628_OK) {
    error = lm628_wait_for(&part, LM628_TRAJECTORY_COMPLETE | LM628_MOTOR_OFF, 1000000, NULL);
  }
  if (error == LM628_OK) error = lm628_read_position(&part, reached);
  return error;
}
