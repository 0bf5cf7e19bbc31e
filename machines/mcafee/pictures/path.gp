# path.svg, of Stage III: the path coloured by the speed along it. contour.svg: the contour errors of
# all runs over time.
if (program ne 'track') exit
count_mm = 1e3 * stage_pitch_m / (4 * encoder_lines)
x = 0.0
y = 0.0
set table $c
plot 'table.csv' using (x = x + column('dx') * count_mm, x):(y = y + column('dy') * count_mm, y) \
  with table
# The same of the run: x, y, speed
set table $d
plot 'trace.csv' every step::first::last using (column('x_mm')):(column('y_mm')):(column('v')) \
  with table
unset table
set datafile separator whitespace
set datafile nocolumnheaders

set terminal svg size 800,700 dynamic enhanced font 'Helvetica,13' background '#ffffff'
set output 'path.svg'
set title title
set size ratio -1
set offsets graph 0.05, graph 0.05, graph 0.05, graph 0.05
set xlabel 'x from the start (mm)'
set ylabel 'y from the start (mm)'
set cblabel 'speed (0..255)'
set cbrange [0:255]
set palette defined (0 '#2c3e9e', 128 '#2ca02c', 255 '#d62728')
set key off
plot $c using 1:2 with lines lc rgb '#bbbbbb' lw 5, \
     $d using 1:2:3 with lines lc palette lw 2

set size noratio
set offsets 0, 0, 0, 0
set terminal svg size 900,420 dynamic enhanced font 'Helvetica,13' background '#ffffff'
set output 'contour.svg'
set xlabel 't (s)'
set ylabel 'contour error (mm)'
set yrange [0:*]
set datafile separator ','
set datafile columnheaders
set key on
colours = '#2ca02c #d62728 #1f77b4'
stats 'contours.csv' using 1 nooutput
plot for [k=2:STATS_columns] 'contours.csv' using 1:k with lines lw 1.2 \
  lc rgb word(colours, k - 1) title columnhead(k)
